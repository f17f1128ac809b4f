/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "elasticModuli.H"
#include "readNumber.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::elasticModuli::elasticModuli(const dictionary& dict)
{
    const bool young = dict.found("E") || dict.found("nu");
    if (young && (dict.found("mu") || dict.found("lambda")))
    {
        FatalIOErrorInFunction(dict)
            << "Found entries of both pairs of moduli, expected either E and nu"
            << " or mu and lambda" << exit(FatalIOError);
    }

    if (young)
    {
        const scalar E = readNumber(dict, "E", dimPressure, 0, GREAT);
        const scalar nu = readNumber(dict, "nu", dimless, -1, 0.5);
        mu = E/(2*(1 + nu));
        lambda = E*nu/((1 + nu)*(1 - 2*nu));
    }
    else if (dict.found("mu"))
    {
        mu = readNumber(dict, "mu", dimPressure, 0, GREAT);
        lambda = readNumber(dict, "lambda", dimPressure, -2*mu/3, GREAT);
    }
    else
    {
        FatalIOErrorInFunction(dict)
            << "Found no moduli, expected E and nu, or mu and lambda"
            << exit(FatalIOError);
    }
}


// ************************************************************************* //
