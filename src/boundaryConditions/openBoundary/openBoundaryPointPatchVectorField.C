/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "openBoundaryPointPatchVectorField.H"
#include "addToRunTimeSelectionTable.H"
#include "readNumber.H"

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
    traction_(Zero)
{
    answer_.backflow = 0.5;
}


Foam::openBoundaryLoad::openBoundaryLoad(const dictionary& dict, const Time& runTime)
:
    pressure_("pressure", dict, 0),
    traction_("traction", dict, Zero),
    pressureCode_(dict, runTime, "pressureCode"),
    tractionCode_(dict, runTime, "tractionCode")
{
    const wordList kinds({"static", "total"});
    const word kind(dict.lookupOrDefault<word>("pressureIs", kinds[0]));
    if (!kinds.found(kind))
    {
        FatalIOErrorInFunction(dict)
            << "Unknown pressureIs " << kind << ". Valid: " << kinds << exit(FatalIOError);
    }
    answer_.total = kind == kinds[1];
    answer_.backflow = answer_.total ? 0 : 0.5;
    if (dict.found("backflowStabilisation"))
    {
        answer_.backflow = readNotNegative(dict, "backflowStabilisation", dimless);
    }
    if (dict.found("impedance"))
    {
        answer_.impedance = readNotNegative(dict, "impedance", dimPressure/dimVelocity);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::openBoundaryLoad::entries()
{
    return patchFieldEntries
    (
        {"pressure", "traction"},
        {"pressureCode", "tractionCode", "pressureIs", "backflowStabilisation", "impedance"}
    );
}


void Foam::openBoundaryLoad::write(Ostream& os) const
{
    pressure_.write(os);
    traction_.write(os);
    pressureCode_.write(os);
    tractionCode_.write(os);
    os.writeEntry("pressureIs", word(answer_.total ? "total" : "static"));
    os.writeEntry("backflowStabilisation", answer_.backflow);
    os.writeEntry("impedance", answer_.impedance);
}


// ************************************************************************* //
