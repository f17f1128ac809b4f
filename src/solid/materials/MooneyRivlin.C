/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Class
    Foam::solidLaws::MooneyRivlin

Description
    Nine-parameter Mooney-Rivlin law in reduced invariants, (10) of Zhang and
    Zhu, with x = I~ - 3 and y = II~ - 3 (reducedPolynomial):

        Wiso = c1 x + c2 y + c3 x^2 + c4 x y + c5 y^2
             + c6 x^3 + c7 x^2 y + c8 x y^2 + c9 y^3

    Coefficients that are not given are nil: two make the law of Mooney, five the
    polynomial of order 2. 2(c1 + c2), the shear modulus, must be positive.

Usage
    \verbatim
    spring
    {
        type            MooneyRivlin;
        rho             1110;           // kg/m3
        bulkModulus     2e9;            // Pa, absent: incompressible
        c1              0.409016e6;     // Pa
        c2              1.991666e4;     // .. c9
    }
    \endverbatim

    Source: M. Mooney, J. Appl. Phys. 11 (1940) 582-592; A.G. James, A. Green,
    G.M. Simpson, J. Appl. Polym. Sci. 19 (1975) 2033-2058 (nine parameters).
\*---------------------------------------------------------------------------*/

#include "reducedPolynomial.H"
#include "readNumber.H"

namespace Foam
{
namespace solidLaws
{

struct MooneyRivlin
{
    static wordList entries()
    {
        return {"c1", "c2", "c3", "c4", "c5", "c6", "c7", "c8", "c9"};
    }

    static reducedPolynomial polynomial(const dictionary& dict)
    {
        const auto c = [&](const word& name)
        {
            return dict.found(name) ? readNumber(dict, name, dimPressure, -GREAT, GREAT) : 0;
        };
        reducedPolynomial W;
        W.a1 = c("c1"); W.c2 = c("c2");
        W.a2 = c("c3"); W.c4 = c("c4"); W.c5 = c("c5");
        W.a3 = c("c6"); W.c7 = c("c7"); W.c8 = c("c8"); W.c9 = c("c9");
        return W;
    }
};

registerReducedPolynomial(MooneyRivlin);

} // End namespace solidLaws
} // End namespace Foam


// ************************************************************************* //
