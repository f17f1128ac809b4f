/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "checkNumbers.H"
#include "dictionary.H"
#include <cmath>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::checkNumbers(const dictionary& dict)
{
    for (const entry& e : dict)
    {
        if (e.isDict())
        {
            checkNumbers(e.dict());
            continue;
        }
        for (const token& t : e.stream())
        {
            if (!t.isNumber() || std::isfinite(t.number())) continue;
            FatalIOErrorInFunction(dict)
                << "Entry " << e.keyword() << " has a number that is beyond all bounds: " << t.number()
                << exit(FatalIOError);
        }
    }
}


// ************************************************************************* //
