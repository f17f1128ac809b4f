/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dofConstraints.H"
#include "PstreamReduceOps.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dofConstraints::tie
(
    const label unknown,
    const UList<term>& masters
)
{
    if (row_[unknown] < 0)
    {
        row_[unknown] = terms_.size();
        terms_.append(DynamicList<term>());
    }
    terms_[row_[unknown]] = masters;
}


void Foam::dofConstraints::share(const nodeMap& map)
{
    // Free 0, tied 1, fixed 2: the largest over the copies counts
    scalarField kind(size());
    label nWeights = 0;
    forAll(kind, u) kind[u] = isFixed(u) ? 2 : isTied(u) ? 1 : 0;
    for (label n = 0; n < map.nNodes(); ++n) nWeights = max(nWeights, map.nUnknowns(n));
    reduce(nWeights, maxOp<label>());
    map.maximum(kind);

    // Weight of component c of the node, as far as a rank knows
    List<scalarField> weight(nWeights, scalarField(size(), -GREAT));
    for (label n = 0; n < map.nNodes(); ++n)
    {
        for (label u = map.start(n); u < map.start(n + 1); ++u)
        {
            if (!isTied(u)) continue;
            for (scalarField& w : weight) w[u] = 0;
            for (const term& t : masters(u)) weight[t.unknown - map.start(n)][u] = t.weight;
        }
    }
    for (scalarField& w : weight) map.maximum(w);

    for (label n = 0; n < map.nNodes(); ++n)
    {
        for (label u = map.start(n); u < map.start(n + 1); ++u)
        {
            if (kind[u] == 2) fix(u);
            if (kind[u] != 1 || isTied(u)) continue;
            DynamicList<term> row;
            for (label c = 0; c < map.nUnknowns(n); ++c)
            {
                if (weight[c][u] != 0) row.append({map.start(n) + c, weight[c][u]});
            }
            tie(u, row);
        }
    }
}


void Foam::dofConstraints::close()
{
    bool changed = true;
    for (label pass = 0; changed; ++pass)
    {
        changed = false;
        forAll(row_, i)
        {
            if (!isTied(i)) continue;
            DynamicList<term>& row = terms_[row_[i]];
            DynamicList<term> closed;
            for (const term& t : row)
            {
                if (isFree(t.unknown)) closed.append(t);
                else changed = true;

                if (!isTied(t.unknown)) continue;
                if (t.unknown == i || pass > row_.size())
                {
                    FatalErrorInFunction
                        << "The constraint of unknown " << i
                        << " refers to itself through unknown " << t.unknown
                        << exit(FatalError);
                }
                for (const term& m : masters(t.unknown))
                {
                    closed.append({m.unknown, t.weight*m.weight});
                }
            }
            row.transfer(closed);
        }
    }
    forAll(row_, i) if (isTied(i) && masters(i).empty()) row_[i] = FIXED;
}


void Foam::dofConstraints::distribute(scalarField& dx) const
{
    forAll(row_, i)
    {
        if (isFree(i)) continue;
        dx[i] = 0;
        if (isTied(i)) for (const term& t : masters(i)) dx[i] += t.weight*dx[t.unknown];
    }
}


void Foam::dofConstraints::condense(scalarField& r) const
{
    forAll(row_, i)
    {
        if (isFree(i)) continue;
        if (isTied(i)) for (const term& t : masters(i)) r[t.unknown] += t.weight*r[i];
        r[i] = 0;
    }
}


// ************************************************************************* //
