/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshBackup.H"
#include "feRegion.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

template<class ZoneMesh>
static List<labelList> listsOf(const ZoneMesh& zones)
{
    List<labelList> lists(zones.size());
    forAll(zones, i) lists[i] = zones[i];
    return lists;
}


//- New one of each old entity, or -1
static labelList reverse(const label nOld, const labelUList& old)
{
    labelList now(nOld, -1);
    forAll(old, i) if (old[i] >= 0) now[old[i]] = i;
    return now;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::meshBackup::meshBackup(feRegion& region)
:
    pointZones_(listsOf(region.mesh().pointZones())),
    faceZones_(listsOf(region.mesh().faceZones())),
    cellZones_(listsOf(region.mesh().cellZones())),
    flipMaps_(faceZones_.size()),
    points0_(region.fe().movedPoints(vectorField(region.fe().nNodes(), Zero))),
    state_(region.state().copy()),
    nCells_(region.mesh().nCells()),
    nVertices_(region.fe().nVertices()),
    nNodes_(region.fe().nNodes())
{
    const fvMesh& mesh = region.mesh();
    forAll(flipMaps_, i) flipMaps_[i] = mesh.faceZones()[i].flipMap();
    mesh_.points = mesh.points();
    mesh_.faces = mesh.faces();
    mesh_.owner = mesh.faceOwner();
    mesh_.neighbour = mesh.faceNeighbour();
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        mesh_.patchSizes.append(pp.size());
        mesh_.patchStarts.append(pp.start());
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::meshBackup::restoreMesh(fvMesh& mesh, const meshExchange& exchanged)
{
    mesh_.pointMap = reverse(mesh_.points.size(), exchanged.pointMap);
    mesh_.faceMap = reverse(mesh_.faces.size(), exchanged.faceMap);
    mesh_.cellMap = reverse(nCells_, exchanged.cellMap);
    mesh_.apply(mesh);
    forAll(pointZones_, i) mesh.pointZones()[i] = pointZones_[i];
    forAll(cellZones_, i) mesh.cellZones()[i] = cellZones_[i];
    forAll(faceZones_, i) mesh.faceZones()[i].resetAddressing(faceZones_[i], flipMaps_[i]);
}


Foam::stateMap Foam::meshBackup::map() const
{
    // Nil, as the state is set afterwards
    stateMap m;
    m.points0 = points0_;
    const auto nil = [](valueMap& map, const label n)
    {
        map.from.setSize(n);
        map.weight.setSize(n);
    };
    nil(m.vertices, nVertices_);
    nil(m.nodes, nNodes_);
    nil(m.cells, mesh_.cellMap.size());
    return m;
}


// ************************************************************************* //
