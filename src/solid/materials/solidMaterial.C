/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidMaterial.H"
#include "readNumber.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(solidMaterial, 0);
    defineRunTimeSelectionTable(solidMaterial, dictionary);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::solidMaterial::solidMaterial(const dictionary& dict)
:
    rho_(readNotNegative(dict, "rho", dimDensity))
{}


Foam::wordList Foam::solidMaterial::entries(const wordList& law)
{
    wordList all({"type", "rho", "cellZone", "Prony", "damping"});
    all.append(law);
    return all;
}


Foam::autoPtr<Foam::solidMaterial> Foam::solidMaterial::New
(
    const dictionary& dict
)
{
    const word type(dict.get<word>("type"));
    auto cstrIter = dictionaryConstructorTablePtr_->cfind(type);
    if (!cstrIter.found())
    {
        FatalIOErrorInLookup
        (
            dict, "material", type, *dictionaryConstructorTablePtr_
        ) << exit(FatalIOError);
    }
    return cstrIter()(dict);
}


// ************************************************************************* //
