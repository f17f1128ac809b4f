/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "flowRateInletPointPatchVectorField.H"
#include "addToRunTimeSelectionTable.H"
#include "IOdictionary.H"
#include "patchFieldEntries.H"
#include "readNumber.H"
#include "unknownEntries.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    makePointPatchTypeField
    (
        pointPatchVectorField,
        flowRateInletPointPatchVectorField
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::flowRateInletPointPatchVectorField::flowRateInletPointPatchVectorField
(
    const pointPatch& p,
    const internal& iF,
    const dictionary& dict
)
:
    base(p, iF, dict, dict.found("value")),
    mass_(dict.found("massFlowRate")),
    rate_(0)
{
    reportUnknownEntries(dict, patchFieldEntries({"volumetricFlowRate", "massFlowRate"}, {"profile"}));
    if (mass_ == dict.found("volumetricFlowRate"))
    {
        FatalIOErrorInFunction(dict)
            << "Patch " << p.name() << " has " << (mass_ ? "both" : "neither")
            << " volumetricFlowRate " << (mass_ ? "and" : "nor") << " massFlowRate, expected one of them"
            << exit(FatalIOError);
    }
    if (iF.name() != "pointU")
    {
        FatalIOErrorInFunction(dict)
            << "Patch " << p.name() << " of field " << iF.name() << " is of type " << type()
            << ", which is for pointU" << exit(FatalIOError);
    }
    rate_.reset(mass_ ? "massFlowRate" : "volumetricFlowRate", dict);

    const wordList profiles({"developed", "flat"});
    const word profile(dict.lookupOrDefault<word>("profile", profiles[0]));
    if (!profiles.found(profile))
    {
        FatalIOErrorInFunction(dict)
            << "Unknown profile " << profile << ". Valid: " << profiles << exit(FatalIOError);
    }
    developed_ = profile == profiles[0];
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::flowRateInletPointPatchVectorField::flowRate(const scalar t) const
{
    if (!mass_) return rate_(t);
    const auto& transport = db().lookupObject<IOdictionary>("transportProperties");
    return rate_(t)/readNumber(transport, "rho", dimDensity, 0, VGREAT);
}


void Foam::flowRateInletPointPatchVectorField::updateCoeffs()
{
    if (updated()) return;
    Field<vector>::operator=(patchInternalField());
    base::updateCoeffs();
}


void Foam::flowRateInletPointPatchVectorField::write(Ostream& os) const
{
    pointPatchVectorField::write(os);
    rate_.write(os);
    os.writeEntry("profile", word(developed_ ? "developed" : "flat"));
    writeEntry("value", os);
}


// ************************************************************************* //
