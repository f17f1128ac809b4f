/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    What materials have beside their laws: viscosity.
\*---------------------------------------------------------------------------*/

#include "solidAssembly.H"
#include "feTimeScheme.H"
#include <memory>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class F>
void Foam::solidAssembly::forViscous
(
    const solidStage& stage,
    const feTimeScheme& ts,
    const vectorField& v,
    const vectorField& D,
    const F& f
) const
{
    forAll(blocks_, b)
    {
        const solidViscosity& viscosity = viscosity_[material_[b]];
        if (viscosity.empty()) continue;
        const viscousStep step
        {
            material(b), mixed(b), viscosity, ts.deltaT(), ts.alphaF(),
            ts.displacementByUnknown(), ts.velocityByUnknown()
        };
        f(b, viscousLoop{step, stage, v, D});
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::solidAssembly::viscous() const
{
    for (const solidViscosity& v : viscosity_) if (!v.empty()) return true;
    return false;
}


void Foam::solidAssembly::setSize(viscousHistory& history) const
{
    label nBranches = 0, nPoints = 0;
    for (const solidViscosity& v : viscosity_) nBranches = max(nBranches, v.nBranches());
    for (const elementBlock& block : blocks_) withElement(block, [&](auto tag)
    {
        typedef referenceTable<decltype(tag)> table;
        nPoints = max(nPoints, label(table::nQ));
    });
    reduce(nPoints, maxOp<label>());
    if (nBranches) history.setSize(fe_.dim(), nPoints, nBranches, fe_.mesh().nCells());
}


void Foam::solidAssembly::addViscous
(
    const solidStage& stage,
    const feTimeScheme& ts,
    const vectorField& v,
    const vectorField& D,
    const viscousHistory& history,
    vectorField& force,
    feMatrix* K,
    const PtrList<elementScatter>& scatter
) const
{
    if (ts.steady()) return;
    forViscous(stage, ts, v, D, [&](const label b, const viscousLoop& loop)
    {
        std::unique_ptr<solidMatrix> to;
        if (K) to.reset(new solidMatrix{*K, scatter[b]});
        loop.assemble(blocks_[b], history, force, to.get());
    });
}


void Foam::solidAssembly::finish
(
    const solidStage& stage,
    const feTimeScheme& ts,
    const vectorField& v,
    const vectorField& D,
    viscousHistory& history
) const
{
    forViscous(stage, ts, v, D, [&](const label b, const viscousLoop& loop)
    {
        if (viscosity_[material_[b]].nBranches()) loop.finish(blocks_[b], ts.steady(), history);
    });
}


// ************************************************************************* //
