/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Class
    Foam::solidLaws::ArrudaBoyce

Description
    Eight-chain law, with the first five terms of the inverse Langevin function:

        Wiso = m sum_k C_k/L^(2(k - 1)) (I~^k - 3^k),   k = 1 .. 5
        C = 1/2, 1/20, 11/1050, 19/7000, 519/673750

    L is the locking stretch of a chain; m follows from the shear modulus mu of
    small strains, mu = 2 m sum_k k C_k (3/L^2)^(k - 1).

Usage
    \verbatim
    rubber
    {
        type            ArrudaBoyce;
        rho             1100;       // kg/m3
        bulkModulus     2e9;        // Pa, absent: incompressible
        mu              0.4e6;      // shear modulus, Pa
        lockingStretch  5;          // > 1
    }
    \endverbatim

    Source: E.M. Arruda, M.C. Boyce, J. Mech. Phys. Solids 41 (1993) 389-412.
\*---------------------------------------------------------------------------*/

#include "reducedPolynomial.H"
#include "readNumber.H"

namespace Foam
{
namespace solidLaws
{

struct ArrudaBoyce
{
    static wordList entries() { return {"mu", "lockingStretch"}; }

    static reducedPolynomial polynomial(const dictionary& dict)
    {
        const scalar mu = readNumber(dict, "mu", dimPressure, 0, GREAT);
        const scalar L = readNumber(dict, "lockingStretch", dimless, 1, GREAT);
        const scalar C[5] = {1.0/2, 1.0/20, 11.0/1050, 19.0/7000, 519.0/673750};

        // I~^k = (3 + x)^k by powers of x
        reducedPolynomial W;
        scalar* a[5] = {&W.a1, &W.a2, &W.a3, &W.a4, &W.a5};
        const scalar binomial[5][5] =
            {{1}, {2, 1}, {3, 3, 1}, {4, 6, 4, 1}, {5, 10, 10, 5, 1}};
        for (label k = 1; k <= 5; ++k) for (label n = 1; n <= k; ++n)
        {
            *a[n - 1] += C[k - 1]*::pow(L, -2.0*(k - 1))*binomial[k - 1][n - 1]*::pow(3.0, k - n);
        }
        const scalar m = mu/W.shearModulus();
        for (scalar* coefficient : a) *coefficient *= m;
        return W;
    }
};

registerReducedPolynomial(ArrudaBoyce);

} // End namespace solidLaws
} // End namespace Foam


// ************************************************************************* //
