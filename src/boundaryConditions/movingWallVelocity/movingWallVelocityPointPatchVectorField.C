/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "movingWallVelocityPointPatchVectorField.H"
#include "pointPatchFields.H"
#include "addToRunTimeSelectionTable.H"
#include "patchFieldEntries.H"
#include "unknownEntries.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    makePointPatchTypeField
    (
        pointPatchVectorField,
        movingWallVelocityPointPatchVectorField
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::movingWallVelocityPointPatchVectorField::movingWallVelocityPointPatchVectorField
(
    const pointPatch& p,
    const internal& iF,
    const dictionary& dict
)
:
    base(p, iF, dict, dict.found("value"))
{
    reportUnknownEntries(dict, patchFieldEntries({}));
    if (iF.name() != "pointU")
    {
        FatalIOErrorInFunction(dict)
            << "Patch " << p.name() << " of field " << iF.name() << " is of type " << type()
            << ", which is for pointU" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::movingWallVelocityPointPatchVectorField::updateCoeffs()
{
    if (updated()) return;
    Field<vector>::operator=(patchInternalField());
    base::updateCoeffs();
}


// ************************************************************************* //
