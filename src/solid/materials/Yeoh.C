/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Class
    Foam::solidLaws::Yeoh

Description
    Law of Yeoh for filled rubbers (reducedPolynomial):

        Wiso = c10 x + c20 x^2 + c30 x^3,   x = I~ - 3

    with the shear modulus 2 c10, which must be positive.

Usage
    \verbatim
    rubber
    {
        type            Yeoh;
        rho             1100;       // kg/m3
        bulkModulus     2e9;        // Pa, absent: incompressible
        c10             0.5e6;      // Pa
        c20             -5e3;       // optional
        c30             2e2;        // optional
    }
    \endverbatim

    Source: O.H. Yeoh, Rubber Chem. Technol. 66 (1993) 754-771.
\*---------------------------------------------------------------------------*/

#include "reducedPolynomial.H"
#include "readNumber.H"

namespace Foam
{
namespace solidLaws
{

struct Yeoh
{
    static wordList entries() { return {"c10", "c20", "c30"}; }

    static reducedPolynomial polynomial(const dictionary& dict)
    {
        const auto c = [&](const word& name)
        {
            return dict.found(name) ? readNumber(dict, name, dimPressure, -GREAT, GREAT) : 0;
        };
        reducedPolynomial W;
        W.a1 = readNumber(dict, "c10", dimPressure, 0, GREAT);
        W.a2 = c("c20");
        W.a3 = c("c30");
        return W;
    }
};

registerReducedPolynomial(Yeoh);

} // End namespace solidLaws
} // End namespace Foam


// ************************************************************************* //
