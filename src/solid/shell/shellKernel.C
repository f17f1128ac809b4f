/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "shellKernel.H"
#include "symmetricSolve.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Directions of the strains
static const int first[] = {0, 1, 2, 0, 1, 0}, second[] = {0, 1, 2, 1, 2, 2};

//- Strains in the element's directions to those of space and back: A^T e A
static Ten<scalar, 3> unitStrain(const int s)
{
    Ten<scalar, 3> e = Ten<scalar, 3>::zero();
    e(first[s], second[s]) += 0.5;
    e(second[s], first[s]) += 0.5;
    return e;
}

} // End namespace Foam


Foam::scalar Foam::shellKernel::sample::strain(const int i, const int j) const
{
    // Not from g: thin elements would have the round-off of the positions
    return (i == j ? 0.5 : 1)*((G[i] & h[j]) + (h[i] & G[j]) + (h[i] & h[j]));
}


void Foam::shellKernel::sample::gradient
(
    const int i,
    const int j,
    const scalar weight,
    vec* B
) const
{
    for (int n = 0; n < nN; ++n)
    {
        if (i == j) B[n] += (weight*dN[n][i])*g[i];
        else B[n] += weight*(dN[n][j]*g[i] + dN[n][i]*g[j]);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::shellKernel::place
(
    sample& s,
    const double* xi,
    const solidNodes<scalar, E>& n
) const
{
    double N[nN];
    E::shape(xi, N, s.dN);
    for (int c = 0; c < 3; ++c)
    {
        s.G[c] = s.h[c] = vec::zero();
        for (int i = 0; i < nN; ++i)
        {
            s.G[c] += s.dN[i][c]*n.X[i];
            s.h[c] += s.dN[i][c]*n.D[i];
        }
        s.g[c] = s.G[c] + s.h[c];
    }
}


void Foam::shellKernel::strains(const int q)
{
    for (auto& row : B_[q]) for (vec& b : row) b = vec::zero();
    for (scalar& e : strain_[q]) e = 0;
    const auto add = [&](const sample& s, const int strain, const scalar weight)
    {
        const int i = first[strain], j = second[strain];
        strain_[q][strain] += weight*s.strain(i, j);
        s.gradient(i, j, weight, B_[q][strain]);
    };
    for (const int strain : {0, 1, 3}) add(point_[q], strain, 1);
    for (int k = 0; k < 4; ++k)
    {
        add(corner_[k], 2, cornerWeight_[q][k]);
        add(edge_[k], k < 2 ? 5 : 4, edgeWeight_[q][k]);
    }
}


void Foam::shellKernel::modes
(
    const int q,
    const double* xi,
    const ten& J,
    const ten& J0,
    const scalar j0
)
{
    const scalar functions[nA] =
    {
        xi[2], xi[2]*xi[0], xi[2]*xi[1], xi[2]*xi[0]*xi[1], xi[0], xi[1], xi[0], xi[1]
    };
    static const int where[nA] = {2, 2, 2, 2, 0, 1, 3, 3};
    const ten T = inv(J0, j0) & J;
    for (int k = 0; k < nA; ++k)
    {
        const ten m = (j0/detJ_[q]*functions[k])*(T.t() & (unitStrain(where[k]) & T));
        for (int s = 0; s < nS; ++s) M_[q][s][k] = (s < 3 ? 1 : 2)*m(first[s], second[s]);
    }
}


void Foam::shellKernel::geometry(const solidNodes<scalar, E>& n)
{
    static const auto rule = quadratureOf<E>::make();
    static const double middle[] = {0, 0, 0};
    static const double corners[4][3] = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    static const double edges[4][3] = {{0, -1, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}};
    for (int k = 0; k < 4; ++k)
    {
        place(corner_[k], corners[k], n);
        place(edge_[k], edges[k], n);
    }
    const auto map = [](const sample& s)
    {
        ten J;
        for (int a = 0; a < 3; ++a) for (int c = 0; c < 3; ++c) J(a, c) = s.G[c][a];
        return J;
    };
    sample centre;
    place(centre, middle, n);
    const ten J0 = map(centre);
    const scalar j0 = det(J0);

    for (int q = 0; q < nQ; ++q)
    {
        const double* xi = rule.x[q].data();
        place(point_[q], xi, n);
        const ten J = map(point_[q]);
        detJ_[q] = det(J);
        dV_[q] = detJ_[q]*rule.w[q];
        dXidX_[q] = inv(J, detJ_[q]);
        N_[q] = referenceTable<E>::instance().N[q];
        for (int k = 0; k < 4; ++k)
        {
            cornerWeight_[q][k] = 0.25*(1 + corners[k][0]*xi[0])*(1 + corners[k][1]*xi[1]);
            edgeWeight_[q][k] = 0.5*(1 + (k < 2 ? edges[k][1]*xi[1] : edges[k][0]*xi[0]));
        }
        strains(q);
        modes(q, xi, J, J0, j0);
    }
}


//- The upper triangular one, of Cholesky's method
Foam::shellKernel::ten Foam::shellKernel::stretch(const int q) const
{
    ten e = ten::zero();
    for (int s = 0; s < nS; ++s)
    {
        scalar value = strain_[q][s];
        for (int k = 0; k < nA; ++k) value += M_[q][s][k]*alpha_[k];
        e += value*unitStrain(s);
    }
    const ten C = (2*(dXidX_[q].t() & (e & dXidX_[q]))).addDiag(1);
    ten U = ten::zero();
    for (int i = 0; i < 3; ++i) for (int j = i; j < 3; ++j)
    {
        scalar sum = C(i, j);
        for (int k = 0; k < i; ++k) sum -= U(k, i)*U(k, j);
        U(i, j) = i == j ? ::sqrt(sum) : sum/U(i, i);
    }
    return U;
}


void Foam::shellKernel::stress(const ten& U, const int q, scalar (&S)[nS]) const
{
    const ten& A = dXidX_[q];
    const ten s = A & ((inv(U) & law_.P(U)) & A.t());
    for (int k = 0; k < nS; ++k) S[k] = s(first[k], second[k]);
}


void Foam::shellKernel::stiffness(const ten& U, const int q, scalar (&C)[nS][nS]) const
{
    const ten &A = dXidX_[q], rU = inv(U), S = rU & law_.P(U);
    for (int k = 0; k < nS; ++k)
    {
        const ten dF = rU.t() & (A.t() & (unitStrain(k) & A));
        const ten dS = A & ((rU & (law_.dP(U, dF) - (dF & S))) & A.t());
        for (int s = 0; s < nS; ++s) C[s][k] = dS(first[s], second[s]);
    }
}


bool Foam::shellKernel::solve()
{
    for (scalar& a : alpha_) a = 0;
    for (int iter = 0; iter < maxIterations; ++iter)
    {
        scalar K[nA][nA] = {}, step[nA] = {}, size = 0;
        for (int q = 0; q < nQ; ++q)
        {
            const ten U = stretch(q);
            scalar S[nS], C[nS][nS];
            stress(U, q, S);
            stiffness(U, q, C);
            for (int k = 0; k < nA; ++k) for (int s = 0; s < nS; ++s)
            {
                step[k] -= M_[q][s][k]*S[s]*dV_[q];
                scalar MC = 0;
                for (int t = 0; t < nS; ++t) MC += M_[q][t][k]*C[t][s];
                for (int l = 0; l < nA; ++l) K[k][l] += MC*M_[q][s][l]*dV_[q];
            }
        }
        symmetricSolve<scalar, nA>([&](const int i, const int j) { return K[i][j]; }).solve(step);

        // In strains, by the size of the mode in space at a point
        for (int k = 0; k < nA; ++k)
        {
            alpha_[k] += step[k];
            ten m = ten::zero();
            for (int s = 0; s < nS; ++s) m += M_[0][s][k]*unitStrain(s);
            m = dXidX_[0].t() & (m & dXidX_[0]);
            size += (m && m)*sqr(step[k]);
        }
        if (::sqrt(size) <= tolerance) return true;
    }
    return false;
}


Foam::scalar Foam::shellKernel::geometric
(
    const int q,
    const scalar (&S)[nS],
    const int i,
    const int j
) const
{
    const auto mixed = [&](const sample& s, const int strain)
    {
        const int a = first[strain], b = second[strain];
        return
            a == b ? s.dN[i][a]*s.dN[j][a]
          : s.dN[i][a]*s.dN[j][b] + s.dN[i][b]*s.dN[j][a];
    };
    scalar sum = 0;
    for (const int strain : {0, 1, 3}) sum += S[strain]*mixed(point_[q], strain);
    for (int k = 0; k < 4; ++k)
    {
        const int shear = k < 2 ? 5 : 4;
        sum += S[2]*cornerWeight_[q][k]*mixed(corner_[k], 2);
        sum += S[shear]*edgeWeight_[q][k]*mixed(edge_[k], shear);
    }
    return sum;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::shellKernel::residual
(
    const solidConstants<3>& k,
    const solidNodes<scalar, E>& n,
    solidResidual<scalar, E>& R
)
{
    geometry(n);
    const bool found = solve();
    for (vec& r : R.u) r = vec::zero();
    R.minDetJ = GREAT;
    for (int q = 0; q < nQ; ++q)
    {
        const sample& p = point_[q];
        ten j;
        for (int a = 0; a < 3; ++a) for (int c = 0; c < 3; ++c) j(a, c) = p.g[c][a];
        R.minDetJ = min(R.minDetJ, det(j));

        vec f = vec::zero();                                                // a - g
        for (int i = 0; i < nN; ++i) f += N_[q][i]*n.a[i];
        for (int b = 0; b < 3; ++b) f[b] -= k.g[b];
        scalar S[nS];
        stress(stretch(q), q, S);
        for (int i = 0; i < nN; ++i)
        {
            R.u[i] += (k.rho*N_[q][i]*dV_[q])*f;
            for (int s = 0; s < nS; ++s) R.u[i] += (S[s]*dV_[q])*B_[q][s][i];
        }
    }
    if (!found) R.minDetJ = -1;
}


void Foam::shellKernel::tangent(const solidConstants<3>& k, solidTangent<scalar, E>& K) const
{
    scalar Kaa[nA][nA] = {};
    vec Kua[nN][nA];
    for (auto& row : Kua) for (vec& v : row) v = vec::zero();
    for (auto& row : K.uu) for (ten& A : row) A = ten::zero();
    for (int q = 0; q < nQ; ++q)
    {
        const ten U = stretch(q);
        scalar S[nS], C[nS][nS], CM[nS][nA] = {};
        stress(U, q, S);
        stiffness(U, q, C);
        for (int s = 0; s < nS; ++s) for (int t = 0; t < nS; ++t)
        {
            C[s][t] *= dV_[q];
            for (int l = 0; l < nA; ++l) CM[s][l] += C[s][t]*M_[q][t][l];
        }
        for (int s = 0; s < nS; ++s) for (int l = 0; l < nA; ++l)
        {
            for (int m = 0; m < nA; ++m) Kaa[m][l] += M_[q][s][m]*CM[s][l];
            for (int i = 0; i < nN; ++i) Kua[i][l] += CM[s][l]*B_[q][s][i];
        }
        for (int j = 0; j < nN; ++j)
        {
            vec CB[nS];
            for (int s = 0; s < nS; ++s)
            {
                CB[s] = C[s][0]*B_[q][0][j];
                for (int t = 1; t < nS; ++t) CB[s] += C[s][t]*B_[q][t][j];
            }
            for (int i = 0; i < nN; ++i)
            {
                for (int s = 0; s < nS; ++s) K.uu[i][j] += B_[q][s][i]*CB[s];
                K.uu[i][j].addDiag(geometric(q, S, i, j)*dV_[q]);
            }
        }
    }

    // Kuu - Kua Kaa^-1 Kau, and the inertia
    const symmetricSolve<scalar, nA> inverse([&](const int i, const int j) { return Kaa[i][j]; });
    for (int j = 0; j < nN; ++j) for (int b = 0; b < 3; ++b)
    {
        scalar x[nA];
        for (int l = 0; l < nA; ++l) x[l] = Kua[j][l][b];
        inverse.solve(x);
        for (int i = 0; i < nN; ++i) for (int a = 0; a < 3; ++a)
        {
            for (int l = 0; l < nA; ++l) K.uu[i][j](a, b) -= Kua[i][l][a]*x[l];
            K.uu[i][j](a, b) *= k.dDdu;
        }
    }
    for (int q = 0; q < nQ; ++q) for (int i = 0; i < nN; ++i) for (int j = 0; j < nN; ++j)
    {
        K.uu[i][j].addDiag(k.dadu*k.rho*N_[q][i]*N_[q][j]*dV_[q]);
    }
}


Foam::scalar Foam::shellKernel::energy(const solidNodes<scalar, E>& n)
{
    geometry(n);
    solve();
    scalar sum = 0;
    for (int q = 0; q < nQ; ++q) sum += law_.W(stretch(q))*dV_[q];
    return sum;
}


// ************************************************************************* //
