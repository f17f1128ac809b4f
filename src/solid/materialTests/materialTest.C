/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "materialTest.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::materialTest::mode> Foam::materialTest::modeNames
({
    {mode::UNIAXIAL, "uniaxial"},
    {mode::EQUIBIAXIAL, "equibiaxial"},
    {mode::PLANAR, "planar"},
    {mode::SHEAR, "shear"},
    {mode::VOLUMETRIC, "volumetric"},
});


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Solve A x = b, n <= 3, by elimination with pivots
static void solve(label n, scalar (&A)[3][3], scalar (&b)[3])
{
    for (label k = 0; k < n; ++k)
    {
        label pivot = k;
        for (label i = k + 1; i < n; ++i) if (mag(A[i][k]) > mag(A[pivot][k])) pivot = i;
        std::swap(A[k], A[pivot]);
        std::swap(b[k], b[pivot]);
        for (label i = 0; i < n; ++i)
        {
            if (i == k) continue;
            const scalar f = A[i][k]/A[k][k];
            for (label j = k; j < n; ++j) A[i][j] -= f*A[k][j];
            b[i] -= f*b[k];
        }
    }
    for (label k = 0; k < n; ++k) b[k] /= A[k][k];
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::materialTest::tension
(
    const scalar l1,
    const scalar l2,
    const label firstFree
) const
{
    // Unknowns: free stretches, and p where J = 1
    const label nFree = 3 - firstFree, n = nFree + (incompressible_ ? 1 : 0);
    scalar l[3] = {l1, l2, 1}, p = 0;
    const scalar held = firstFree == 1 ? l1 : l1*l2;
    for (label i = firstFree; i < 3; ++i) l[i] = ::pow(held, -1.0/nFree);

    for (label iter = 0; iter < 100; ++iter)
    {
        ten F = ten::zero();
        for (label i = 0; i < 3; ++i) F(i, i) = l[i];
        const scalar J = det(F);
        const ten P0 = P(F);

        // P_ii - p J/l_i = 0,  J - 1 = 0
        scalar A[3][3] = {}, dx[3] = {};
        for (label i = 0; i < nFree; ++i)
        {
            const label I = firstFree + i;
            dx[i] = -(P0(I, I) - p*J/l[I]);
            for (label j = 0; j < nFree; ++j)
            {
                const label K = firstFree + j;
                ten dF = ten::zero();
                dF(K, K) = 1;
                A[i][j] = dP(F, dF)(I, I) - (I == K ? 0 : p*J/(l[I]*l[K]));
            }
            if (incompressible_) A[i][nFree] = A[nFree][i] = J/l[I];
            if (incompressible_) A[i][nFree] *= -1;
        }
        if (incompressible_) dx[nFree] = 1 - J;
        solve(n, A, dx);

        scalar change = 0;
        for (label i = 0; i < nFree; ++i) change = max(change, mag(dx[i])/l[firstFree + i]);
        const scalar step = min(scalar(1), 0.3/max(change, VSMALL));
        for (label i = 0; i < nFree; ++i) l[firstFree + i] += step*dx[i];
        if (incompressible_) p += step*dx[nFree];
        if (change < 1e-13) return P0(0, 0) - p*J/l1;
        if (!std::isfinite(change)) break;
    }
    FatalErrorInFunction
        << "No equilibrium of the material at the stretches " << l1 << ' ' << l2
        << exit(FatalError);
    return 0;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::materialTest::materialTest(const solidMaterial& law)
:
    law_(law),
    incompressible_(dynamic_cast<const mixedMaterial*>(&law))
{
    if (incompressible_ && incompressible_->rKappa() > 0) incompressible_ = nullptr;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::materialTest::load(const mode m, const scalar x) const
{
    ten F = ten::I();
    switch (m)
    {
        case mode::UNIAXIAL: return tension(x, 1, 1);
        case mode::EQUIBIAXIAL: return tension(x, x, 2);
        case mode::PLANAR: return tension(x, 1, 2);
        case mode::SHEAR:
            // The pressure makes no part of P_12
            F(0, 1) = x;
            return P(F)(0, 1);
        default:
            break;
    }
    if (incompressible_)
    {
        FatalErrorInFunction
            << "A material without bulkModulus has no volumetric test" << exit(FatalError);
    }
    F = ::cbrt(x)*ten::I();
    return -tr(P(F) & F.t())/(3*x);
}


// ************************************************************************* //
