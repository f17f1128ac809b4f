/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "feLinearSolver.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(feLinearSolver, 0);
    defineRunTimeSelectionTable(feLinearSolver, dictionary);
}


const Foam::Enum<Foam::feLinearSolver::outcome>
Foam::feLinearSolver::outcomeNames
({
    { outcome::OK, "OK" },
    { outcome::SINGULAR, "SINGULAR" },
    { outcome::OUT_OF_MEMORY, "OUT_OF_MEMORY" },
    { outcome::FAILED, "FAILED" },
});


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::feLinearSolver> Foam::feLinearSolver::New
(
    const dictionary& dict
)
{
    const word type(dict.get<word>("type"));

    const auto cstrIter = dictionaryConstructorTablePtr_->cfind(type);

    if (!cstrIter.found())
    {
        FatalIOErrorInLookup
        (
            dict,
            "linearSolver",
            type,
            *dictionaryConstructorTablePtr_
        ) << exit(FatalIOError);
    }

    return cstrIter()(dict);
}


// ************************************************************************* //
