/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tieInterface.H"
#include "addToRunTimeSelectionTable.H"
#include "unknownEntries.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(tieInterface, 0);
    addToRunTimeSelectionTable(feInterface, tieInterface, dictionary);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::tieInterface::checkMeshes() const
{
    const motionField& m = static_cast<const feRegion&>(leader()).motion();
    const motionField& s = static_cast<const feRegion&>(follower()).motion();
    const vectorField D(tie_.fromLeader(m.D));
    scalar largest = 0;
    forAll(D, i) largest = max(largest, mag(D[i] - s.D[tie_.nodes()[i]]));
    reduce(largest, maxOp<scalar>());
    if (largest <= 1e-9*mesh_) return;
    FatalIOErrorInFunction(dict())
        << "Interface " << name() << ": the meshes of regions " << follower().name() << " and "
        << leader().name() << " have moved apart there, by " << largest << " m." << nl
        << "Hold the meshes at rest on the tie's patches, by pointDisplacement fixedValue uniform (0 0 0)"
        << " in both regions" << exit(FatalIOError);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::tieInterface::tieInterface
(
    const word& name,
    const dictionary& dict,
    PtrList<feRegion>& regions
)
:
    feInterface(name, dict, regions, "master", "slave"),
    tie_(*this, dict),
    mesh_(follower().mesh().bounds().mag())
{
    if (leader().leads() != follower().leads()) failRegions("two solids or two fluids");
    if (&leader() == &follower()) failRegions("two regions");
    reportUnknownEntries(dict, {"type", "master", "slave", "tolerance", "weights", "unmatched"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::tieInterface::constrain(dofConstraints& c)
{
    tie_.find(leader().fe().points(), follower().fe().points(), true);
    tie_.constrain(c);
}


void Foam::tieInterface::follow()
{
    // pointD: D, DVelocity, ...; pointU: U, URate
    const word name(follower().motionConditions().name().substr(5));
    for (statePart& part : follower().state().parts())
    {
        const HashTable<vectorField*> values(part.vectors());
        for (const word& key : values.sortedToc())
        {
            const vectorField* from = leader().state().find<vector>(key);
            if (!key.startsWith(name) || !from) continue;
            const vectorField taken(tie_.fromLeader(*from));
            forAll(taken, i) (*values[key])[tie_.nodes()[i]] = taken[i];
        }
    }
    if (!follower().leads()) checkMeshes();
}


// ************************************************************************* //
