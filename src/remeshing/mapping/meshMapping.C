/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshMapping.H"
#include "emptyPolyPatch.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(meshMapping, 0);
    defineRunTimeSelectionTable(meshMapping, dictionary);
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::meshMapping> Foam::meshMapping::New(const dictionary& dict)
{
    const word type(dict.getOrDefault<word>("mapping", "interpolation"));
    auto cstrIter = dictionaryConstructorTablePtr_->cfind(type);
    if (!cstrIter.found())
    {
        FatalIOErrorInLookup(dict, "mapping", type, *dictionaryConstructorTablePtr_) << exit(FatalIOError);
    }
    return cstrIter()(dict.subOrEmptyDict(type + "Coeffs"));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::meshMapping::keptNodes(const source& old, const feMesh& now)
{
    // Mid-side nodes inside are where the motion of the new mesh begins: between
    // their ends
    boolList kept(now.nNodes(), false);
    for (const elementBlock& block : now.blocks()) for (label e = 0; e < block.size(); ++e)
    {
        if (old.made[block.cells[e]]) continue;
        for (label i = 0; i < block.nVertices(); ++i) kept[block.element(e)[i]] = true;
    }
    forAll(now.mesh().boundaryMesh(), patchi)
    {
        for (const elementBlock& block : now.patchBlocks(patchi)) for (const label n : block.nodes) kept[n] = true;
    }

    // Vertices by their points, others by their parents
    labelList from(now.nNodes(), -1);
    for (label n = 0; n < now.nVertices(); ++n)
    {
        const label p = old.pointMap[now.vertexPoint()[n]];
        if (p >= 0) from[n] = old.fe.pointNode()[p];
    }
    HashTable<label, labelList, Hash<labelList>> oldNode;
    const auto sorted = [](labelList list) { Foam::sort(list); return list; };
    for (label n = old.fe.nVertices(); n < old.fe.nNodes(); ++n)
    {
        oldNode.insert(sorted(old.fe.parents()[n]), n);
    }
    for (label n = now.nVertices(); n < now.nNodes(); ++n)
    {
        if (!kept[n]) continue;
        labelList parents(now.parents()[n]);
        for (label& p : parents) p = from[p];
        from[n] = oldNode.lookup(sorted(parents), -1);
    }
    return from;
}


// ************************************************************************* //
