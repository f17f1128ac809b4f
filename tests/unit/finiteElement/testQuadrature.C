/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Tests of the quadrature rules: monomials up to the documented degree.
\*---------------------------------------------------------------------------*/

#include "quadrature.H"
#include <gtest/gtest.h>

using namespace Foam;

namespace
{

double factorial(const int n) { return n < 2 ? 1 : n*factorial(n - 1); }

//- Of x^n over [-1,1]
double line(const int n) { return n % 2 ? 0 : 2.0/(n + 1); }

double triangle(const int i, const int j)
{
    return factorial(i)*factorial(j)/factorial(i + j + 2);
}

double tet(const int i, const int j, const int k)
{
    return factorial(i)*factorial(j)*factorial(k)/factorial(i + j + k + 3);
}

//- Of x^i y^j z^k over the pyramid
double pyramid(const int i, const int j, const int k)
{
    return line(i)*line(j)*factorial(k)*factorial(i + j + 2)/factorial(i + j + k + 3);
}

double power(const double x, const int n) { return n ? x*power(x, n - 1) : 1; }

//- Test all monomials x^i y^j z^k with used(i, j, k) against exact(i, j, k)
template<class E, class Used, class Exact>
void testRule(const int maxDegree, const Used& used, const Exact& exact)
{
    const auto rule = quadratureOf<E>::make();
    for (int i = 0; i <= maxDegree; ++i)
    for (int j = 0; j <= (E::dim > 1 ? maxDegree : 0); ++j)
    for (int k = 0; k <= (E::dim > 2 ? maxDegree : 0); ++k)
    {
        if (!used(i, j, k)) continue;
        const int n[3] = {i, j, k};
        double sum = 0;
        for (int q = 0; q < rule.nPoints; ++q)
        {
            double f = 1;
            for (int a = 0; a < E::dim; ++a) f *= power(rule.x[q][a], n[a]);
            sum += rule.w[q]*f;
        }
        EXPECT_NEAR(sum, exact(i, j, k), 4e-16 + 1e-14*std::abs(exact(i, j, k)))
            << E::name << ": x^" << i << " y^" << j << " z^" << k;
    }
}

//- Lines and their products: each power up to the degree
template<class E>
void testProduct(const int degree)
{
    testRule<E>
    (
        degree,
        [](int, int, int) { return true; },
        [](int i, int j, int k)
        {
            return line(i)*(E::dim > 1 ? line(j) : 1)*(E::dim > 2 ? line(k) : 1);
        }
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(quadrature, linesAndTheirProducts)
{
    testProduct<Line1>(3);
    testProduct<Quad1>(3);
    testProduct<Hex1>(3);
    testProduct<Line2>(5);
    testProduct<Quad2>(5);
    testProduct<Hex2>(5);
}


TEST(quadrature, triangles)
{
    const auto total = [](const int n) { return [n](int i, int j, int) { return i + j <= n; }; };
    const auto exact = [](int i, int j, int) { return triangle(i, j); };
    testRule<Tri1>(2, total(2), exact);
    testRule<Tri2>(5, total(5), exact);
}


TEST(quadrature, tets)
{
    const auto total = [](const int n) { return [n](int i, int j, int k) { return i + j + k <= n; }; };
    testRule<Tet1>(2, total(2), tet);
    testRule<Tet2>(5, total(5), tet);
}


TEST(quadrature, prism)
{
    testRule<Prism1>
    (
        3,
        [](int i, int j, int k) { return i + j <= 2 && k <= 3; },
        [](int i, int j, int k) { return triangle(i, j)*line(k); }
    );
}


TEST(quadrature, pyramid)
{
    testRule<Pyramid1>
    (
        3,
        [](int i, int j, int k) { return i <= 3 && j <= 3 && i + j + k <= 3; },
        pyramid
    );
}


TEST(quadrature, weightsArePositiveAndPointsInside)
{
    const auto test = [](auto tag)
    {
        typedef decltype(tag) E;
        const auto rule = quadratureOf<E>::make();
        for (int q = 0; q < rule.nPoints; ++q)
        {
            EXPECT_GT(rule.w[q], 0) << E::name;
            double N[E::nNodes], dN[E::nNodes][E::dim];
            E::Linear::shape(rule.x[q].data(), N, dN);
            for (int i = 0; i < E::nVertices; ++i) EXPECT_GT(N[i], 0) << E::name;
        }
    };
    test(Line1()); test(Line2());
    test(Tri1()); test(Tri2()); test(Quad1()); test(Quad2());
    test(Tet1()); test(Tet2()); test(Hex1()); test(Hex2()); test(Prism1()); test(Pyramid1());
}


// ************************************************************************* //
