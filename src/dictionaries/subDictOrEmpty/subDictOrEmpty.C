/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "subDictOrEmpty.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::dictionary Foam::subDictOrEmpty
(
    const dictionary& dict,
    const word& keyword
)
{
    if (!dict.found(keyword)) return dictionary();

    const entry& e = dict.lookupEntry(keyword, keyType::REGEX);
    if (!e.isDict())
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << keyword << " is no dictionary, expected "
            << keyword << " { ... }" << exit(FatalIOError);
    }
    return e.dict();
}


// ************************************************************************* //
