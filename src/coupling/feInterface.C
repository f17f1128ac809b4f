/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "feInterface.H"
#include "unknownEntries.H"
#include "OStringStream.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(feInterface, 0);
    defineRunTimeSelectionTable(feInterface, dictionary);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::feRegion& Foam::feInterface::region
(
    const dictionary& dict,
    PtrList<feRegion>& regions
)
{
    const word name(dict.get<word>("region"));
    wordList names(regions.size());
    forAll(regions, i)
    {
        names[i] = regions[i].name();
        if (names[i] == name) return regions[i];
    }
    FatalIOErrorInFunction(dict)
        << "There is no region '" << name << "' with a region solver. Regions: "
        << names << exit(FatalIOError);
    return regions[0];
}


Foam::labelList Foam::feInterface::patches
(
    const dictionary& dict,
    const feRegion& region
)
{
    if (!dict.found("patches"))
    {
        return labelList(1, region.fe().patchIndex(dict.get<word>("patch"), dict));
    }
    return region.fe().patchIndices(dict.get<wordRes>("patches"), dict);
}


Foam::labelList Foam::feInterface::nodes
(
    const feRegion& region,
    const labelUList& patches
)
{
    if (patches.size() == 1) return region.fe().patchNodes(patches[0]);
    labelHashSet all;
    for (const label patchi : patches) all.insert(region.fe().patchNodes(patchi));
    return all.sortedToc();
}


void Foam::feInterface::checkFree
(
    const feRegion& region,
    const labelUList& patches
) const
{
    const pointVectorField& field = region.motionConditions();
    for (const label patchi : patches)
    {
        const pointPatchVectorField& patch = field.boundaryField()[patchi];
        if (!nodalBoundary::constrains(patch)) continue;
        FatalIOErrorInFunction(dict_)
            << "Patch " << patch.patch().name() << " of " << field.objectPath()
            << " is of type " << patch.type() << ", but on interface " << name_
            << " fluid and solid move together as they will."
            << " Expected type calculated" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::feInterface::checkFree() const
{
    checkFree(fluid_, fluidPatches_);
    checkFree(solid_, solidPatches_);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::feInterface::feInterface
(
    const word& name,
    const dictionary& dict,
    PtrList<feRegion>& regions
)
:
    name_(name),
    dict_(dict),
    fluid_(region(dict.subDict("fluid"), regions)),
    solid_(region(dict.subDict("solid"), regions)),
    fluidPatches_(patches(dict.subDict("fluid"), fluid_)),
    solidPatches_(patches(dict.subDict("solid"), solid_)),
    followed_(false)
{
    for (const word side : {"fluid", "solid"})
    {
        reportUnknownEntries(dict.subDict(side), {"region", "patch", "patches"});
    }
    if (fluid_.leads() || !solid_.leads())
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


Foam::autoPtr<Foam::feInterface> Foam::feInterface::New
(
    const word& name,
    const dictionary& dict,
    PtrList<feRegion>& regions
)
{
    const word type(dict.get<word>("type"));
    auto cstrIter = dictionaryConstructorTablePtr_->cfind(type);
    if (!cstrIter.found())
    {
        FatalIOErrorInLookup
        (
            dict, "interface type", type, *dictionaryConstructorTablePtr_
        ) << exit(FatalIOError);
    }
    return cstrIter()(name, dict, regions);
}



// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::feInterface::checkApart(const feInterface& other) const
{
    const auto fail = [&](const feRegion& region, const string& what)
    {
        FatalIOErrorInFunction(dict_)
            << "Interfaces " << other.name() << " and " << name() << " both have " << what.c_str()
            << " of region " << region.name() << '.' << nl
            << "A side of an interface may have several patches: patches (a b);"
            << exit(FatalIOError);
    };
    const auto checkPatches = [&](const feRegion& region, const labelUList& mine, const labelUList& others)
    {
        for (const label patchi : mine)
        {
            if (others.found(patchi)) fail(region, "patch " + region.mesh().boundaryMesh()[patchi].name());
        }
    };
    if (&solid_ == &other.solid_) checkPatches(solid_, solidPatches_, other.solidPatches_);
    if (&fluid_ != &other.fluid_) return;
    checkPatches(fluid_, fluidPatches_, other.fluidPatches_);
    if (sharesNodes() && other.sharesNodes()) return;

    const labelHashSet nodes(other.fluidNodes());
    point where = point::max;
    for (const label n : fluidNodes()) if (nodes.found(n)) where = fluid_.fe().points()[n];
    reduce(where, minOp<point>());
    if (where == point::max) return;
    OStringStream os;
    os << "the node at " << where;
    fail(fluid_, os.str());
}


// ************************************************************************* //
