/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The exchange itself, and what refuses it.
\*---------------------------------------------------------------------------*/

#include "regionRemeshing.H"
#include "simplexExchange.H"
#include "simplexField.H"
#include "meshBackup.H"
#include "gatherAll.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Of all ranks
static string first(const string& mine)
{
    for (const string& s : gatherAll<string>(List<string>(1, mine))) if (!s.empty()) return s;
    return "";
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::string Foam::regionRemeshing::makeMesh
(
    const labelUList& cells,
    const vectorField& x,
    const elementSearch& search,
    meshExchange& e
) const
{
    const feMesh& fe = region_.fe();
    labelList nodes;
    const simplexMesh old(simplicesOf(fe, x, cells, nodes));
    simplexMesh now(old);
    scalarField sizes(nodes.size());
    forAll(nodes, i) sizes[i] = memory_.size(nodes[i]);
    string failure;
    if (!cells.empty()) failure = remesher_->remesh(old, simplexField(old, sizes), now);
    if (failure.empty()) failure = table_.worse(old, now);
    if (!failure.empty()) return failure;
    failure = simplexExchange(fe, fe.movedPoints(region_.motion().D), cells).make(now, nodes, e);
    if (!failure.empty()) return failure;

    // New cells have the old one at their centre
    label k = 0;
    for (label& c : e.cellMap)
    {
        if (c >= 0) continue;
        point centre = Zero;
        for (const label p : now.cells[k]) for (label a = 0; a < fe.dim(); ++a)
        {
            centre[fe.axis(a)] += now.points[p][a]/now.cells[k].size();
        }
        const elementSearch::place place(search.find(centre, GREAT));
        if (place.block < 0) return "a new cell is not in the old mesh";
        c = search.cell(place);
        ++k;
    }
    return "";
}


void Foam::regionRemeshing::discretise(const stateMap& map)
{
    List<const stateMap*> maps(system_.regions().size(), nullptr);
    maps[regioni_] = &map;
    system_.discretise(maps);
    memory_.setPoints0(map.points0);
}


Foam::string Foam::regionRemeshing::apply
(
    meshExchange& e,
    const label nKept,
    const vectorField& x,
    const elementSearch& search
)
{
    fvMesh& mesh = region_.mesh();
    const feMesh& old = region_.fe();

    // Kept cells come first, in their order
    const labelList pointMap(e.pointMap), cellMap(e.cellMap);
    boolList made(cellMap.size(), false);
    forAll(made, c) made[c] = c >= nKept;
    const scalarField size(memory_.sizes());

    e.apply(mesh);
    stateMap map;
    map.points0 = mesh.points();
    string failure;
    try
    {
        const feMesh now(mesh, old.order(), feRegion::readSchemes(mesh), map.points0);
        failure = mapping_->map({old, x, search, pointMap, cellMap, made}, now, map);
    }
    catch (const error& e)
    {
        // Sides that were curved are straight, or the other way round
        failure = e.message();
    }
    failure = first(failure);
    if (!failure.empty()) return failure;
    discretise(map);
    memory_.setSizes(map.vertices(size));

    // Interpolated rates of the old mesh's motion are not those of the new one's,
    // which would oscillate about its own
    if (region_.follower()) region_.follower()->followedAtStart();
    return "";
}


Foam::labelList Foam::regionRemeshing::oldVertices(const labelUList& oldNode, const labelUList& pointMap) const
{
    labelList old(region_.fe().nVertices(), -1);
    forAll(old, n)
    {
        const label p = pointMap[region_.fe().vertexPoint()[n]];
        if (p >= 0) old[n] = oldNode[p];
    }
    return old;
}


Foam::exchangeAudit Foam::regionRemeshing::audit(const labelUList& oldVertices)
{
    system_.linearise();
    return exchangeAudit(region_, patches_, oldVertices);
}


Foam::string Foam::regionRemeshing::finish
(
    const exchangeAudit& before,
    const labelList& oldVertices,
    const clockValue& start
)
{
    const auto inverted = [&]() { return returnReduce(region_.minDetJ(), minOp<scalar>()) <= 0; };
    if (mapping_->projects() && system_.projects() && !system_.project())
    {
        if (inverted()) return "an element of the new mesh is inverted: " + region_.worstElement();
        return "the projection of the velocities has failed";
    }
    const exchangeAudit after(audit(oldVertices));
    if (inverted()) return "an element of the new mesh is inverted: " + region_.worstElement();
    table_.report(before, after, start.elapsed());
    return table_.broken(before, after);
}


bool Foam::regionRemeshing::refuse(const string& why) const
{
    WarningInFunction
        << "Region " << region_.name() << ": the exchange of the mesh is refused: " << why.c_str()
        << ". The old mesh stays" << endl;
    return false;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::regionRemeshing::exchange(const string& why, const labelHashSet& bad)
{
    const clockValue start(true);
    Info<< "Remeshing of region " << region_.name() << " at time " << region_.mesh().time().timeName()
        << ": " << why.c_str() << nl;
    const vectorField x(present());
    const elementSearch search(region_.fe(), x);
    const labelList cells(selection_.cells(region_.fe(), bad));
    if (!any(bad))
    {
        Info<< "    No cell that may be exchanged is bad: the mesh stays" << nl << endl;
        return false;
    }
    meshExchange e;
    string failure(first(makeMesh(cells, x, search, e)));
    if (!failure.empty()) return refuse(failure);

    const exchangeAudit before(audit());
    meshBackup backup(region_);
    const scalarField sizes(memory_.sizes());
    const labelList oldNode(region_.fe().pointNode());
    failure = apply(e, region_.mesh().nCells() - cells.size(), x, search);
    if (failure.empty()) failure = finish(before, oldVertices(oldNode, e.pointMap), start);
    if (failure.empty())
    {
        region_.derive();
        return true;
    }
    backup.restoreMesh(region_.mesh(), e);
    discretise(backup.map());
    region_.state().set(backup.state());
    memory_.setSizes(sizes);
    return refuse(failure);
}


// ************************************************************************* //
