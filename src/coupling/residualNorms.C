/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "residualNorms.H"
#include <limits>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::residualNorms::findRoundOff(const feMatrix& K)
{
    const List<systemUnknowns::block>& blocks = unknowns_.blocks();
    scalarField size(blocks.size(), 0);
    forAll(blocks, b)
    {
        size[b] =
            10*std::numeric_limits<scalar>::epsilon()
           *regions_[blocks[b].region].unknownScale(blocks[b].field);
    }

    scalarField diagonal(roundOff_.size(), 0);
    roundOff_ = 0;
    forAll(roundOff_, u)
    {
        const label b = unknowns_.blockOf(u);
        K.forRow(u, [&](const label v, const scalar entry)
        {
            if (v == u) diagonal[u] = entry;
            else if (unknowns_.blockOf(v) != b) roundOff_[u] += mag(entry)*size[unknowns_.blockOf(v)];
        });
    }
    unknowns_.map().sum(diagonal);
    unknowns_.map().sum(roundOff_);
    forAll(roundOff_, u) roundOff_[u] += size[unknowns_.blockOf(u)]*mag(diagonal[u]);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::residualNorms::residualNorms
(
    const systemUnknowns& unknowns,
    const PtrList<feRegion>& regions
)
:
    unknowns_(unknowns),
    regions_(regions),
    norm_(unknowns.blocks().size(), 0),
    first_(norm_),
    scale_(norm_.size(), 1),
    roundOff_(unknowns.map().nUnknowns(), 0),
    rowScale_(roundOff_.size(), 1)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::residualNorms::update
(
    const scalarField& R,
    const scalarField& raw,
    const feMatrix& K,
    const bool first
)
{
    if (first) findRoundOff(K);

    // What is not a number stays one
    scalarField free(norm_.size(), 0), reaction(free), all(free);
    for (const label u : unknowns_.map().ownedUnknowns())
    {
        const label b = unknowns_.blockOf(u);
        if (unknowns_.constraints().isFree(u))
        {
            all[b] += sqr(R[u]);
            if (!(mag(R[u]) <= roundOff_[u])) free[b] += sqr(mag(R[u]) - roundOff_[u]);
        }
        else
        {
            reaction[b] += sqr(raw[u]);
        }
    }
    for (scalarField* sum : {&free, &reaction, &all})
    {
        Pstream::listCombineGather(*sum, plusEqOp<scalar>());
        Pstream::listCombineScatter(*sum);
    }

    const List<systemUnknowns::block>& blocks = unknowns_.blocks();
    forAll(norm_, b)
    {
        norm_[b] = ::sqrt(free[b]);
        if (first) first_[b] = ::sqrt(all[b]);
        const scalar given = regions_[blocks[b].region].residualScale(blocks[b].field);
        scale_[b] = given > 0 ? given : max(first_[b], ::sqrt(reaction[b]));
        if (!(scale_[b] > 0)) scale_[b] = 1;
    }
    forAll(rowScale_, u) rowScale_[u] = 1/scale_[unknowns_.blockOf(u)];
}


Foam::scalar Foam::residualNorms::largest() const
{
    scalar norm = 0;
    forAll(norm_, b)
    {
        if (!std::isfinite(scaled(b))) return scaled(b);
        norm = max(norm, scaled(b));
    }
    return norm;
}


Foam::label Foam::residualNorms::worst(const scalarField& R) const
{
    scalar largest = -1;
    label at = -1;
    for (const label u : unknowns_.map().ownedUnknowns())
    {
        if (!unknowns_.constraints().isFree(u)) continue;
        const scalar r = std::isfinite(R[u]) ? mag(R[u])*rowScale_[u] : GREAT;
        if (r > largest)
        {
            largest = r;
            at = unknowns_.map().global(u);
        }
    }
    const scalar most = returnReduce(largest, maxOp<scalar>());
    return returnReduce(largest == most ? at : -1, maxOp<label>());
}


// ************************************************************************* //
