/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "openBoundaryPointPatchVectorField.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineNamedTemplateTypeNameAndDebug(openBoundaryPointPatchVectorField, 0);
    addToPointPatchFieldRunTimeSelection
    (
        pointPatchVectorField,
        openBoundaryPointPatchVectorField
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::openBoundaryLoad::openBoundaryLoad()
:
    pressure_(0),
    traction_(Zero),
    backflow_(0.5)
{}


Foam::openBoundaryLoad::openBoundaryLoad(const dictionary& dict, const Time& runTime)
:
    pressure_("pressure", dict, 0),
    traction_("traction", dict, Zero),
    pressureCode_(dict, runTime, "pressureCode"),
    tractionCode_(dict, runTime, "tractionCode"),
    backflow_(dict.lookupOrDefault<scalar>("backflowStabilisation", 0.5))
{
    if (backflow_ < 0)
    {
        FatalIOErrorInFunction(dict)
            << "backflowStabilisation is " << backflow_ << ", expected >= 0:"
            << " 0 for none, 0.5 to bound the energy that comes in"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::openBoundaryLoad::entries()
{
    return patchFieldEntries({"pressure", "traction"}, {"pressureCode", "tractionCode", "backflowStabilisation"});
}


void Foam::openBoundaryLoad::write(Ostream& os) const
{
    pressure_.write(os);
    traction_.write(os);
    pressureCode_.write(os);
    tractionCode_.write(os);
    os.writeEntry("backflowStabilisation", backflow_);
}


// ************************************************************************* //
