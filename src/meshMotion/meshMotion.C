/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshMotion.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(meshMotion, 0);
    defineRunTimeSelectionTable(meshMotion, dictionary);
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::word Foam::meshMotion::select(const dictionary& dict)
{
    const word type(dict.get<word>("motionSolver"));
    if (!dictionaryConstructorTablePtr_->found(type))
    {
        FatalIOErrorInLookup
        (
            dict, "motionSolver", type, *dictionaryConstructorTablePtr_
        ) << exit(FatalIOError);
    }
    return type;
}


Foam::autoPtr<Foam::meshMotion> Foam::meshMotion::New
(
    const feMesh& fe,
    pointVectorField* boundary,
    const labelUList& heldPatches,
    const dictionary& dict,
    const dictionary& solver
)
{
    const word type(select(dict));
    return dictionaryConstructorTablePtr_->cfind(type)()
    (
        fe, boundary, heldPatches, dict.subOrEmptyDict(type + "Coeffs"), solver
    );
}


// ************************************************************************* //
