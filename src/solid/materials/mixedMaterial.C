/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "mixedMaterial.H"
#include "readNumber.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(mixedMaterial, 0);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::mixedMaterial::mixedMaterial(const dictionary& dict)
:
    solidMaterial(dict),
    rKappa_
    (
        dict.found("bulkModulus") ? 1/readNumber(dict, "bulkModulus", dimPressure, 0, GREAT) : 0
    )
{}


Foam::wordList Foam::mixedMaterial::entries(const wordList& law)
{
    wordList all(solidMaterial::entries({"bulkModulus"}));
    all.append(law);
    return all;
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::mixedMaterial::checkShearModulus(const dictionary& dict) const
{
    if (shearModulus() > 0 && shearModulus() < GREAT) return;
    FatalIOErrorInFunction(dict)
        << "The shear modulus of small strains is " << shearModulus()
        << " Pa, expected a positive number" << exit(FatalIOError);
}


// ************************************************************************* //
