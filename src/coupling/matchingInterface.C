/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "matchingInterface.H"
#include "nodalBoundary.H"
#include "indexedOctree.H"
#include "treeDataPoint.H"
#include "ListListOps.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::feRegion& Foam::matchingInterface::region
(
    const dictionary& dict,
    const PtrList<feRegion>& regions
)
{
    const word name(dict.get<word>("region"));
    wordList names(regions.size());
    forAll(regions, i)
    {
        names[i] = regions[i].name();
        if (names[i] == name) return const_cast<feRegion&>(regions[i]);
    }
    FatalIOErrorInFunction(dict)
        << "There is no region '" << name << "' with a region solver. Regions: "
        << names << exit(FatalIOError);
    return const_cast<feRegion&>(regions[0]);
}


void Foam::matchingInterface::fail
(
    const List<scalarList>& gaps,
    const List<pointField>& places
) const
{
    label n = 0;
    scalar largest = 0;
    point where = Zero;
    forAll(gaps, rank) forAll(gaps[rank], i)
    {
        ++n;
        if (gaps[rank][i] < largest) continue;
        largest = gaps[rank][i];
        where = places[rank][i];
    }
    if (!n) return;
    FatalIOErrorInFunction(dict_)
        << "Interface " << name_ << " does not match: " << n
        << " nodes of patch " << fluid_.mesh().boundaryMesh()[fluidPatch_].name()
        << " (region " << fluid_.name() << ") and patch "
        << solid_.mesh().boundaryMesh()[solidPatch_].name()
        << " (region " << solid_.name() << ") have no partner." << nl
        << "Largest gap " << largest << " m at " << where << '.' << nl
        << "Both meshes need the same points on the interface, and elements of"
        << " the same order." << exit(FatalIOError);
}


void Foam::matchingInterface::checkFree(const feRegion& region, const label patchi) const
{
    const pointVectorField& field = region.motionConditions();
    const pointPatchVectorField& patch = field.boundaryField()[patchi];
    if (!nodalBoundary::constrains(patch)) return;
    FatalIOErrorInFunction(dict_)
        << "Patch " << patch.patch().name() << " of " << field.objectPath()
        << " is of type " << patch.type() << ", but on interface " << name_
        << " fluid and solid move together as they will."
        << " Expected type calculated" << exit(FatalIOError);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::matchingInterface::matchingInterface
(
    const word& name,
    const dictionary& dict,
    const PtrList<feRegion>& regions
)
:
    name_(name),
    dict_(dict),
    fluid_(region(dict.subDict("fluid"), regions)),
    solid_(region(dict.subDict("solid"), regions)),
    fluidPatch_(fluid_.fe().patchIndex(dict.subDict("fluid").get<word>("patch"), dict.subDict("fluid"))),
    solidPatch_(solid_.fe().patchIndex(dict.subDict("solid").get<word>("patch"), dict.subDict("solid")))
{
    if (!fluid_.interfaceFollower() || !solid_.interfaceMotion())
    {
        FatalIOErrorInFunction(dict)
            << "Interface " << name << " joins region " << fluid_.name()
            << " of type " << fluid_.type() << " as fluid and region "
            << solid_.name() << " of type " << solid_.type() << " as solid;"
            << " expected a fluid and a solid" << exit(FatalIOError);
    }
    if (!(fluid_.timeScheme() == solid_.timeScheme()))
    {
        FatalIOErrorInFunction(dict)
            << "Regions " << fluid_.name() << " and " << solid_.name()
            << " have different time schemes; unknowns are shared, so the"
            << " entries timeScheme of their feSchemes must be the same"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::matchingInterface::match
(
    const labelUList& solidKey,
    labelList& fluidKey
) const
{
    const label me = Pstream::myProcNo();
    List<pointField> points(Pstream::nProcs());
    List<labelList> keys(Pstream::nProcs());
    points[me] = pointField(solid_.fe().points(), solidNodes());
    keys[me] = UIndirectList<label>(solidKey, solidNodes())();
    Pstream::gatherList(points);
    Pstream::scatterList(points);
    Pstream::gatherList(keys);
    Pstream::scatterList(keys);
    const pointField all(ListListOps::combine<pointField>(points, accessOp<pointField>()));
    const labelList allKeys(ListListOps::combine<labelList>(keys, accessOp<labelList>()));

    List<scalarList> gaps(Pstream::nProcs());
    List<pointField> places(Pstream::nProcs());
    const vectorField& X = fluid_.fe().points();

    // In 2-D the meshes may lie at different depths
    const label depth = fluid_.fe().dim() == 2 ? fluid_.fe().axis(2) : -1;
    const auto flat = [&](point p) { if (depth >= 0) p[depth] = 0; return p; };

    pointField flatAll(all);
    for (point& p : flatAll) p = flat(p);
    treeBoundBox bb(flatAll);
    const scalar tolerance = dict_.lookupOrDefault<scalar>("tolerance", 1e-6)*bb.mag();
    bb.inflate(0.01);
    bb.min() -= vector::uniform(SMALL + 1e-3*bb.mag());
    bb.max() += vector::uniform(SMALL + 1e-3*bb.mag());
    const indexedOctree<treeDataPoint> tree(treeDataPoint(flatAll), bb, 10, 10, 3);

    labelHashSet met;
    for (const label n : fluidNodes())
    {
        const pointIndexHit hit = tree.findNearest(flat(X[n]), sqr(GREAT));
        const scalar gap = hit.hit() ? mag(flat(X[n]) - hit.hitPoint()) : GREAT;
        if (gap <= tolerance)
        {
            fluidKey[n] = allKeys[hit.index()];
            met.insert(fluidKey[n]);
        }
        else
        {
            gaps[me].append(gap);
            places[me].append(X[n]);
        }
    }

    // Solid nodes that no fluid node of any rank has met
    List<labelList> metKeys(Pstream::nProcs());
    metKeys[me] = met.toc();
    Pstream::gatherList(metKeys);
    Pstream::scatterList(metKeys);
    labelHashSet allMet;
    for (const labelList& k : metKeys) allMet.insert(k);
    for (const label n : solidNodes())
    {
        if (allMet.found(solidKey[n])) continue;
        gaps[me].append(0);
        places[me].append(solid_.fe().points()[n]);
    }

    Pstream::gatherList(gaps);
    Pstream::scatterList(gaps);
    Pstream::gatherList(places);
    Pstream::scatterList(places);
    fail(gaps, places);

    checkFree(fluid_, fluidPatch_);
    checkFree(solid_, solidPatch_);
}


// ************************************************************************* //
