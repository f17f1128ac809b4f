/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidElements.H"
#include "dictionary.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static const List<solidElements>& table()
{
    typedef fieldLayout::support on;
    static const List<solidElements> all
    ({
        {"linear", 1, false, false, false, on::VERTICES},
        {"enhancedStrain", 1, true, false, false, on::VERTICES},
        {"solidShell", 1, false, true, false, on::VERTICES},
        {"quadratic", 2, false, false, false, on::VERTICES},
        {"Q1Q0", 1, false, false, true, on::CELLS},
        {"equalOrder", 1, false, false, true, on::VERTICES},
        {"taylorHood", 2, false, false, true, on::VERTICES},
    });
    return all;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::solidElements& Foam::solidElements::select(const dictionary& schemes)
{
    const word name(schemes.get<word>("elements"));
    wordList names;
    for (const solidElements& e : table())
    {
        if (e.name == name) return e;
        names.append(e.name);
    }
    FatalIOErrorInFunction(schemes)
        << "Unknown elements " << name << ". Valid: " << names << exit(FatalIOError);
    return table()[0];
}


// ************************************************************************* //
