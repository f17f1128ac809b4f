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


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::tieInterface::tieInterface
(
    const word& name,
    const dictionary& dict,
    PtrList<feRegion>& regions
)
:
    feInterface(name, dict, regions, "master", "slave"),
    tie_(*this, dict)
{
    if (!leader().leads() || !follower().leads()) failRegions("two solids");
    if (&leader() == &follower()) failRegions("two regions");
    reportUnknownEntries(dict, {"type", "master", "slave", "tolerance", "weights", "unmatched"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::labelPair> Foam::tieInterface::joined
(
    const labelUList&,
    const labelUList&
) const
{
    checkFree();
    return List<labelPair>();
}


void Foam::tieInterface::constrain(dofConstraints& c)
{
    tie_.find(leader().fe().points(), follower().fe().points(), true);
    tie_.constrain(c);
}


void Foam::tieInterface::follow()
{
    const motionField& m = static_cast<const feRegion&>(leader()).motion();
    motionField& s = follower().motion();
    const vectorField D(tie_.fromLeader(m.D)), v(tie_.fromLeader(m.v)), a(tie_.fromLeader(m.a));
    forAll(D, i)
    {
        const label n = tie_.nodes()[i];
        s.D[n] = D[i];
        s.v[n] = v[i];
        s.a[n] = a[i];
    }
}


// ************************************************************************* //
