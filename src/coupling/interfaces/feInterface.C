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
            << " the two regions move together as they will."
            << " Expected type calculated" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::feInterface::checkFree() const
{
    checkFree(leader_, leaderPatches_);
    checkFree(follower_, followerPatches_);
}


void Foam::feInterface::failRegions(const char* expected) const
{
    FatalIOErrorInFunction(dict_)
        << "Interface " << name_ << " joins region " << follower_.name()
        << " of type " << follower_.type() << " to region " << leader_.name()
        << " of type " << leader_.type() << "; expected " << expected << exit(FatalIOError);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::feInterface::feInterface
(
    const word& name,
    const dictionary& dict,
    PtrList<feRegion>& regions,
    const word& leader,
    const word& follower
)
:
    name_(name),
    dict_(dict),
    leader_(region(dict.subDict(leader), regions)),
    follower_(region(dict.subDict(follower), regions)),
    leaderPatches_(patches(dict.subDict(leader), leader_)),
    followerPatches_(patches(dict.subDict(follower), follower_))
{
    for (const word& side : {leader, follower})
    {
        reportUnknownEntries(dict.subDict(side), {"region", "patch", "patches"});
    }
    if (!(follower_.timeScheme() == leader_.timeScheme()))
    {
        FatalIOErrorInFunction(dict)
            << "Regions " << follower_.name() << " and " << leader_.name()
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

Foam::List<Foam::labelPair> Foam::feInterface::joined(const labelUList&, const labelUList&) const
{
    checkFree();
    return List<labelPair>();
}


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
    if (&leader_ == &other.leader_) checkPatches(leader_, leaderPatches_, other.leaderPatches_);
    if (&follower_ != &other.follower_) return;
    checkPatches(follower_, followerPatches_, other.followerPatches_);
    if (sharesNodes() && other.sharesNodes()) return;

    const labelHashSet nodes(other.followerNodes());
    point where = point::max;
    for (const label n : followerNodes()) if (nodes.found(n)) where = follower_.fe().points()[n];
    reduce(where, minOp<point>());
    if (where == point::max) return;
    OStringStream os;
    os << "the node at " << where;
    fail(follower_, os.str());
}


// ************************************************************************* //
