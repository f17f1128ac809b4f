/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "followerPressurePointPatchVectorField.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineNamedTemplateTypeNameAndDebug(followerPressurePointPatchVectorField, 0);
    addToPointPatchFieldRunTimeSelection
    (
        pointPatchVectorField,
        followerPressurePointPatchVectorField
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::followerPressureLoad::followerPressureLoad(const dictionary& dict, const Time& runTime)
:
    pressure_(loadFunction<scalar>("pressure", dict, "pressureCode")),
    code_(dict, runTime, "pressureCode")
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::followerPressureLoad::write(Ostream& os) const
{
    pressure_.write(os);
    code_.write(os);
}


// ************************************************************************* //
