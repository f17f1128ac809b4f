/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Class
    Foam::solidLaws::isochoricNeoHookean

Description
    Neo-Hookean law of the distortion (reducedPolynomial):

        Wiso = mu/2 (I~ - 3)

    The law neoHookean does not part distortion and volume; the two agree where
    J = 1.

Usage
    \verbatim
    rubber
    {
        type            isochoricNeoHookean;
        rho             1100;       // kg/m3
        bulkModulus     2e9;        // Pa, absent: incompressible
        mu              80.1938e6;  // shear modulus, Pa
    }
    \endverbatim

    Source: G.A. Holzapfel, Nonlinear Solid Mechanics (2000), section 6.5.
\*---------------------------------------------------------------------------*/

#include "reducedPolynomial.H"
#include "readNumber.H"

namespace Foam
{
namespace solidLaws
{

struct isochoricNeoHookean
{
    static wordList entries() { return {"mu"}; }

    static reducedPolynomial polynomial(const dictionary& dict)
    {
        reducedPolynomial W;
        W.a1 = 0.5*readNumber(dict, "mu", dimPressure, 0, GREAT);
        return W;
    }
};

registerReducedPolynomial(isochoricNeoHookean);

} // End namespace solidLaws
} // End namespace Foam


// ************************************************************************* //
