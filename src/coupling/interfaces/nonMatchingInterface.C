/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "nonMatchingInterface.H"
#include "addToRunTimeSelectionTable.H"
#include "unknownEntries.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(nonMatchingInterface, 0);
    addToRunTimeSelectionTable(feInterface, nonMatchingInterface, dictionary);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::nonMatchingInterface::holds() const
{
    const vectorField &D = fluid().motion().D, D0(tie_.fromLeader(solid().motion().D) + tie_.offset());
    scalar size = 0, difference = 0;
    forAll(D0, i)
    {
        if (!tie_.isMatched(i)) continue;
        size = max(size, mag(D0[i]));
        difference = max(difference, mag(D[tie_.nodes()[i]] - D0[i]));
    }
    reduce(size, maxOp<scalar>());
    reduce(difference, maxOp<scalar>());
    return difference <= 1e-6*size;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::nonMatchingInterface::nonMatchingInterface
(
    const word& name,
    const dictionary& dict,
    PtrList<feRegion>& regions
)
:
    fsiInterface(name, dict, regions),
    tie_(*this, dict, dict.lookupOrDefault<Switch>("snap", false))
{
    reportUnknownEntries(dict, {"type", "fluid", "solid", "tolerance", "weights", "unmatched", "snap"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::nonMatchingInterface::constrain(dofConstraints& c)
{
    if (!tie_.find(solid().fe().points(), fluid().fe().points(), false) || (followed() && !holds()))
    {
        tie_.find(surfaceTie::present(solid()), surfaceTie::present(fluid()), true);
    }
    tie_.constrain(c);
}


void Foam::nonMatchingInterface::follow()
{
    const motionField& s = static_cast<const feRegion&>(solid()).motion();
    motionField& f = fluid().motion();
    const vectorField D(tie_.fromLeader(s.D)), v(tie_.fromLeader(s.v)), a(tie_.fromLeader(s.a));
    forAll(D, i)
    {
        const label n = tie_.nodes()[i];
        f.D[n] = D[i] + tie_.offset()[i];
        f.v[n] = v[i];
        f.a[n] = a[i];
    }
}


// ************************************************************************* //
