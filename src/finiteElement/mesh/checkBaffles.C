/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "checkBaffles.H"
#include "polyMesh.H"
#include "emptyPolyPatch.H"
#include "labelIOList.H"
#include "PstreamBuffers.H"
#include "SubField.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- A face by its points in ascending order
struct sheet
{
    labelList points;
    label patch;
    point centre;

    bool operator!=(const sheet& s) const { return points != s.points || patch != s.patch; }
    friend Ostream& operator<<(Ostream& os, const sheet& s)
    {
        return os << s.points << ' ' << s.patch << ' ' << s.centre;
    }
    friend Istream& operator>>(Istream& is, sheet& s)
    {
        return is >> s.points >> s.patch >> s.centre;
    }
};


//- Numbers of the points in the mesh that was decomposed. Where there are none,
//  faces of different ranks have nothing in common
static labelList undecomposed(const polyMesh& mesh)
{
    const label n = returnReduce(mesh.nPoints(), maxOp<label>());
    const labelList own(identity(mesh.nPoints(), n*Pstream::myProcNo()));
    if (!Pstream::parRun()) return own;

    const labelIOList original
    (
        IOobject
        (
            "pointProcAddressing", mesh.facesInstance(), polyMesh::meshSubDir, mesh,
            IOobject::READ_IF_PRESENT, IOobject::NO_WRITE, false
        )
    );
    bool complete = original.size() == mesh.nPoints();
    reduce(complete, andOp<bool>());
    return complete ? labelList(original) : own;
}


static List<sheet> boundaryFaces(const polyMesh& mesh)
{
    const labelList number(undecomposed(mesh));
    DynamicList<sheet> faces;
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (pp.coupled() || isA<emptyPolyPatch>(pp)) continue;
        forAll(pp, i)
        {
            labelList points(number, pp[i]);
            Foam::sort(points);
            faces.append(sheet{points, pp.index(), pp.faceCentres()[i]});
        }
    }
    return List<sheet>(std::move(faces));
}


//- Faces of all ranks, those with the same points on the same rank
static List<sheet> together(const List<sheet>& mine)
{
    if (!Pstream::parRun()) return mine;
    List<DynamicList<sheet>> to(Pstream::nProcs());
    for (const sheet& s : mine) to[s.points[0] % Pstream::nProcs()].append(s);

    PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);
    forAll(to, rank)
    {
        UOPstream os(rank, buffers);
        os << to[rank];
    }
    buffers.finishedSends();
    DynamicList<sheet> all;
    forAll(to, rank)
    {
        UIPstream is(rank, buffers);
        all.append(List<sheet>(is));
    }
    return List<sheet>(std::move(all));
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::checkBaffles(const polyMesh& mesh)
{
    const List<sheet> faces(together(boundaryFaces(mesh)));
    HashTable<label, labelList, Hash<labelList>> faceOn;
    label n = 0, first = -1, second = -1;
    point where = Zero;
    for (const sheet& s : faces)
    {
        if (faceOn.insert(s.points, s.patch)) continue;
        ++n;
        first = faceOn[s.points];
        second = s.patch;
        where = s.centre;
    }
    const label nAll = returnReduce(n, sumOp<label>());
    if (!n) return;
    FatalErrorInFunction
        << "Region " << mesh.name() << " has " << nAll << " pairs of boundary faces on the same"
        << " points, one on patches " << mesh.boundaryMesh()[first].name() << " and "
        << mesh.boundaryMesh()[second].name() << " at " << where << ": a baffle." << nl
        << "A node there has one value for both sides, so pressure would pass through. Give each"
        << " side its own points: mergeOrSplitBaffles -region " << mesh.name()
        << " -split -overwrite" << (Pstream::parRun() ? ", and decompose the case anew" : "")
        << exit(FatalError);
}


// ************************************************************************* //
