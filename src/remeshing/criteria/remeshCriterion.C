/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "remeshCriterion.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(remeshCriterion, 0);
    defineRunTimeSelectionTable(remeshCriterion, dictionary);
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::remeshCriterion> Foam::remeshCriterion::New(const dictionary& dict)
{
    const word type(dict.get<word>("type"));
    auto cstrIter = dictionaryConstructorTablePtr_->cfind(type);
    if (!cstrIter.found())
    {
        FatalIOErrorInLookup(dict, "criterion", type, *dictionaryConstructorTablePtr_) << exit(FatalIOError);
    }
    return cstrIter()(dict);
}


// ************************************************************************* //
