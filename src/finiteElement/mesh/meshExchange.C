/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshExchange.H"
#include "mapPolyMesh.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static labelList reverse(const label nOld, const labelUList& map)
{
    labelList r(nOld, -1);
    forAll(map, i) if (map[i] >= 0) r[map[i]] = i;
    return r;
}


//- The new entities of each zone
template<class ZoneMesh>
static List<labelList> zones(const ZoneMesh& all, const labelUList& map)
{
    List<labelList> z(all.size());
    forAll(all, i)
    {
        DynamicList<label> in;
        forAll(map, k) if (map[k] >= 0 && all[i].localID(map[k]) >= 0) in.append(k);
        z[i] = in;
    }
    return z;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::meshExchange::apply(fvMesh& mesh)
{
    const label nOldPoints = mesh.nPoints(), nOldFaces = mesh.nFaces(), nOldCells = mesh.nCells();
    labelList oldStarts(mesh.boundaryMesh().size()), oldSizes(oldStarts);
    List<Map<label>> oldPatchPoints(oldStarts.size());
    forAll(mesh.boundaryMesh(), p)
    {
        oldStarts[p] = mesh.boundaryMesh()[p].start();
        oldSizes[p] = mesh.boundaryMesh()[p].nPoints();
        oldPatchPoints[p] = mesh.boundaryMesh()[p].meshPointMap();
    }
    const List<labelList> pointZones(zones(mesh.pointZones(), pointMap));
    const List<labelList> faceZones(zones(mesh.faceZones(), faceMap));
    const List<labelList> cellZones(zones(mesh.cellZones(), cellMap));

    const autoPtr<scalarField> oldVolumes(new scalarField(mesh.cellVolumes()));
    mesh.resetMotion();
    mesh.resetPrimitives
    (
        autoPtr<pointField>(new pointField(std::move(points))),
        autoPtr<faceList>(new faceList(std::move(faces))),
        autoPtr<labelList>(new labelList(owner)),
        autoPtr<labelList>(new labelList(neighbour)),
        patchSizes, patchStarts
    );
    forAll(pointZones, i) mesh.pointZones()[i] = pointZones[i];
    forAll(cellZones, i) mesh.cellZones()[i] = cellZones[i];
    forAll(faceZones, i)
    {
        mesh.faceZones()[i].resetAddressing(faceZones[i], boolList(faceZones[i].size(), false));
    }

    labelListList patchPoints(oldStarts.size());
    forAll(patchPoints, p)
    {
        const labelList& now = mesh.boundaryMesh()[p].meshPoints();
        patchPoints[p].setSize(now.size(), -1);
        forAll(now, i)
        {
            if (pointMap[now[i]] < 0) continue;
            patchPoints[p][i] = oldPatchPoints[p].lookup(pointMap[now[i]], -1);
        }
    }
    const List<objectMap> none;
    mesh.updateMesh
    (
        mapPolyMesh
        (
            mesh, nOldPoints, nOldFaces, nOldCells,
            pointMap, none, faceMap, none, none, none, cellMap, none, none, none, none,
            reverse(nOldPoints, pointMap), reverse(nOldFaces, faceMap), reverse(nOldCells, cellMap),
            labelHashSet(), patchPoints,
            labelListList(pointZones.size()), labelListList(faceZones.size()),
            labelListList(faceZones.size()), labelListList(cellZones.size()),
            pointField(), oldStarts, oldSizes, oldVolumes
        )
    );
}


// ************************************************************************* //
