/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshFiles.H"
#include "Time.H"
#include "OSspecific.H"
#include "polyMesh.H"
#include "polyBoundaryMeshEntries.H"
#include "pointIOField.H"
#include "faceIOList.H"
#include "labelIOList.H"
#include "fileOperation.H"
#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static void checkPresent(const Time& time, const word& region)
{
    const fileName dir(region/polyMesh::meshSubDir);
    const word instance(time.findInstance(dir, "faces", IOobject::READ_IF_PRESENT));
    const bool found =
        isFile(time.path()/instance/dir/"faces")
     || isFile(time.path()/time.constant()/dir/"faces");
    label nMissing = found ? 0 : 1;
    reduce(nMissing, sumOp<label>());
    if (!nMissing) return;
    FatalErrorInFunction
        << "Region " << region << " has no mesh in " << time.path()/time.constant()/dir;
    if (Pstream::parRun())
    {
        FatalError
            << ", nor have " << nMissing << " of " << Pstream::nProcs() << " ranks." << nl
            << "Decompose all regions for this number of ranks: decomposePar -allRegions";
    }
    else
    {
        FatalError << '.' << nl << "Make it, with blockMesh -region " << region << " say";
    }
    FatalError << exit(FatalError);
}


//- The files of one mesh, read without a mesh
class meshFiles
{
    const Time& time_;
    const fileName dir_;

    IOobject object(const word& name, const word& instance) const
    {
        return IOobject
        (
            name, instance, dir_, time_, IOobject::MUST_READ, IOobject::NO_WRITE, false
        );
    }

    word instance(const word& name) const { return time_.findInstance(dir_, name); }


    void fail(const IOobject& file, const string& what) const
    {
        FatalErrorInFunction
            << "File " << file.objectPath() << ": " << what.c_str() << "." << nl
            << "Make the mesh anew, or repair the file" << exit(FatalError);
    }

    void checkCells(const labelIOList& cells, const label nFaces, const bool padded) const
    {
        forAll(cells, f)
        {
            if (cells[f] < nFaces && (cells[f] >= 0 || (padded && cells[f] == -1))) continue;
            fail
            (
                cells,
                "face " + name(f) + " has cell " + name(cells[f]) + " of a mesh of " + name(nFaces) + " faces"
            );
        }
    }

    void checkFaces(const faceCompactIOList& faces, const label nPoints) const
    {
        forAll(faces, f)
        {
            bool right = faces[f].size() >= 3;
            for (const label p : faces[f]) right = right && p >= 0 && p < nPoints;
            if (right) continue;
            OStringStream os;
            os << "face " << f << " is " << labelList(faces[f]) << ", expected three points or more from 0 to "
                << nPoints - 1;
            fail(faces, os.str());
        }
    }

    void checkPatches(const polyBoundaryMeshEntries& patches, const label nInternal, const label nFaces) const
    {
        label next = nInternal;
        for (const entry& patch : patches)
        {
            const label n = patch.dict().get<label>("nFaces"), start = patch.dict().get<label>("startFace");
            if (n < 0 || start != next)
            {
                fail
                (
                    patches,
                    "patch " + patch.keyword() + " has " + name(n) + " faces from " + name(start)
                  + " on, expected them from " + name(next) + " on"
                );
            }
            next += n;
        }
        if (next == nFaces) return;
        fail(patches, "the patches end at face " + name(next) + ", expected " + name(nFaces));
    }


public:

    meshFiles(const Time& time, const word& region)
    :
        time_(time),
        dir_(region/polyMesh::meshSubDir)
    {}

    void check() const
    {
        const word at(instance("faces"));
        const pointIOField points(object("points", instance("points")));
        const faceCompactIOList faces(object("faces", at));
        const labelIOList owner(object("owner", at)), neighbour(object("neighbour", at));
        const polyBoundaryMeshEntries patches
        (
            object("boundary", time_.findInstance(dir_, "boundary", IOobject::MUST_READ, at))
        );

        forAll(points, p)
        {
            if (!std::isfinite(mag(points[p]))) fail(points, "the position of point " + name(p) + " is no number");
        }
        checkFaces(faces, points.size());
        if (owner.size() != faces.size() || neighbour.size() > faces.size())
        {
            fail
            (
                owner,
                name(owner.size()) + " owners and " + name(neighbour.size()) + " neighbours of "
              + name(faces.size()) + " faces"
            );
        }
        const bool padded = neighbour.size() == faces.size();
        checkCells(owner, faces.size(), false);
        checkCells(neighbour, faces.size(), padded);
        const label nPadding = std::count(neighbour.begin(), neighbour.end(), -1);
        checkPatches(patches, neighbour.size() - nPadding, faces.size());
    }
};

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::checkMeshFiles(const Time& time, const word& region)
{
    if (fileHandler().type() != "uncollated") return;
    checkPresent(time, region);
    meshFiles(time, region).check();
}


// ************************************************************************* //
