/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Tests of the reference elements and of feValues, one for each element.
\*---------------------------------------------------------------------------*/

#include "feSecondValues.H"
#include "feSimd.H"
#include <gtest/gtest.h>
#include <random>

using namespace Foam;

namespace
{

template<class E>
struct elements : ::testing::Test
{
    static constexpr int dim = E::dim, n = E::nNodes;
    typedef Vec<double, dim> vec;

    std::mt19937 random{7};
    double uniform() { return std::uniform_real_distribution<double>(-1, 1)(random); }

    //- A point in the reference shape
    std::array<double, dim> inside()
    {
        std::array<double, dim> x{};
        double sum = 0, weight[E::nVertices];
        for (double& w : weight) sum += w = 1.2 + uniform();
        for (int i = 0; i < E::nVertices; ++i)
        {
            for (int a = 0; a < dim; ++a) x[a] += weight[i]/sum*E::xi[i][a];
        }
        return x;
    }

    //- An affine image of the element's nodes, turned and sheared
    vec affine(const double* xi) const
    {
        vec x;
        for (int a = 0; a < dim; ++a)
        {
            x[a] = 0.3 - a + 1.7*xi[a];
            for (int b = 0; b < dim; ++b) x[a] += (0.3*(a + 1) - 0.2*b)*xi[b];
        }
        return x;
    }

    void nodes(vec* x, const double distortion)
    {
        for (int i = 0; i < n; ++i)
        {
            x[i] = affine(E::xi[i]);
            for (int a = 0; a < dim; ++a) x[i][a] += distortion*uniform();
        }
    }

    //- A polynomial of the element's order, and its gradient
    static double polynomial(const vec& x)
    {
        double p = 0.4;
        for (int a = 0; a < dim; ++a)
        {
            p += (a + 1)*x[a];
            if (E::order == 2) for (int b = 0; b <= a; ++b) p += (0.3*a - b + 0.7)*x[a]*x[b];
        }
        return p;
    }

    static vec gradient(const vec& x)
    {
        vec g;
        for (int a = 0; a < dim; ++a) g[a] = a + 1;
        if (E::order == 2) for (int a = 0; a < dim; ++a) for (int b = 0; b <= a; ++b)
        {
            g[a] += (0.3*a - b + 0.7)*x[b];
            g[b] += (0.3*a - b + 0.7)*x[a];
        }
        return g;
    }
};

typedef ::testing::Types
<
    Line1, Line2, Tri1, Tri2, Quad1, Quad2, Tet1, Tet2, Hex1, Hex2, Prism1, Pyramid1
> allElements;

struct elementNames
{
    template<class E> static std::string GetName(int) { return E::name; }
};

TYPED_TEST_SUITE(elements, allElements, elementNames);

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TYPED_TEST(elements, partitionOfUnity)
{
    typedef TypeParam E;
    for (int trial = 0; trial < 20; ++trial)
    {
        double N[E::nNodes], dN[E::nNodes][E::dim];
        E::shape(this->inside().data(), N, dN);
        double sum = 0;
        for (const double Ni : N) sum += Ni;
        EXPECT_NEAR(sum, 1, 1e-14);
        for (int a = 0; a < E::dim; ++a)
        {
            double dSum = 0;
            for (int i = 0; i < E::nNodes; ++i) dSum += dN[i][a];
            EXPECT_NEAR(dSum, 0, 1e-13);
        }
    }
}


TYPED_TEST(elements, oneAtItsNodeNilAtOthers)
{
    typedef TypeParam E;
    for (int j = 0; j < E::nNodes; ++j)
    {
        // The pyramid's functions have a limit only at the apex
        double x[E::dim];
        for (int a = 0; a < E::dim; ++a) x[a] = E::xi[j][a];
        if (E::nNodes == 5 && j == 4) x[2] -= 1e-14;

        double N[E::nNodes], dN[E::nNodes][E::dim];
        E::shape(x, N, dN);
        for (int i = 0; i < E::nNodes; ++i) EXPECT_NEAR(N[i], i == j, 2e-14) << i << ' ' << j;
    }
}


TYPED_TEST(elements, derivativesAreThoseOfTheFunctions)
{
    typedef TypeParam E;
    const double h = 1e-6;
    for (int trial = 0; trial < 10; ++trial)
    {
        auto x = this->inside();
        double N[E::nNodes], dN[E::nNodes][E::dim];
        E::shape(x.data(), N, dN);
        for (int a = 0; a < E::dim; ++a)
        {
            double plus[E::nNodes], minus[E::nNodes], unused[E::nNodes][E::dim];
            auto y = x;
            y[a] += h;
            E::shape(y.data(), plus, unused);
            y[a] -= 2*h;
            E::shape(y.data(), minus, unused);
            for (int i = 0; i < E::nNodes; ++i)
            {
                EXPECT_NEAR(dN[i][a], (plus[i] - minus[i])/(2*h), 1e-8);
            }
        }
    }
}


//- Nodes of order 2 lie where the tables of edges and quads say
TYPED_TEST(elements, higherNodesAreMeansOfTheirParents)
{
    typedef TypeParam E;
    if constexpr (E::order == 2)
    {
        const auto expectMean = [&](const int node, const int* parents, const int nParents)
        {
            for (int a = 0; a < E::dim; ++a)
            {
                double mean = 0;
                for (int i = 0; i < nParents; ++i) mean += E::xi[parents[i]][a]/nParents;
                EXPECT_NEAR(E::xi[node][a], mean, 1e-15) << node;
            }
        };
        for (int e = 0; e < E::nEdges; ++e) expectMean(E::nVertices + e, E::edges[e], 2);
        const bool centres = E::nNodes > E::nVertices + E::nEdges;
        for (int q = 0; centres && q < E::nQuads; ++q)
        {
            expectMean(E::nVertices + E::nEdges + q, E::quads[q], 4);
        }
    }
}


//- Order 1 on any element, order 2 on affine ones
TYPED_TEST(elements, reproducesPolynomials)
{
    typedef TypeParam E;
    feValues<double, E> fe;
    typename elements<E>::vec x[E::nNodes];
    double p[E::nNodes];
    this->nodes(x, E::order == 1 ? 0.15 : 0);
    for (int i = 0; i < E::nNodes; ++i) p[i] = this->polynomial(x[i]);

    for (int q = 0; q < fe.nQ; ++q)
    {
        fe.reinit(x, q);
        const auto X = fe.value(x);
        EXPECT_NEAR(fe.value(p), this->polynomial(X), 1e-12);
        const auto g = fe.grad(p), exact = this->gradient(X);
        for (int a = 0; a < E::dim; ++a) EXPECT_NEAR(g[a], exact[a], 1e-11);
    }
}


//- Linear functions belong to order 2 on curved elements, too
TYPED_TEST(elements, reproducesItsOwnMap)
{
    typedef TypeParam E;
    feValues<double, E> fe;
    typename elements<E>::vec x[E::nNodes];
    this->nodes(x, 0.08);
    for (int q = 0; q < fe.nQ; ++q)
    {
        fe.reinit(x, q);
        const auto I = fe.grad(x);
        for (int a = 0; a < E::dim; ++a) for (int b = 0; b < E::dim; ++b)
        {
            EXPECT_NEAR(I(a, b), a == b, 1e-12);
        }
    }
}


//- int div x dV = dim V, and V of the affine image known
TYPED_TEST(elements, integratesItsVolume)
{
    typedef TypeParam E;
    feValues<double, E> fe;
    typename elements<E>::vec x[E::nNodes];
    this->nodes(x, 0);
    double reference = 0, volume = 0;
    for (int q = 0; q < fe.nQ; ++q)
    {
        fe.reinit(x, q);
        reference += fe.ref.w[q];
        volume += fe.dV;
    }
    Ten<double, E::dim> A;
    double origin[E::dim] = {};
    for (int b = 0; b < E::dim; ++b)
    {
        double e[E::dim] = {};
        e[b] = 1;
        const auto column = this->affine(e) - this->affine(origin);
        for (int a = 0; a < E::dim; ++a) A(a, b) = column[a];
    }
    EXPECT_NEAR(volume, det(A)*reference, 1e-13*volume);
}


//- All lanes of a pack give what double gives; what a lane gives does not
//  depend on the others, to the bit
TYPED_TEST(elements, aPackIsSeveralDoubles)
{
    typedef TypeParam E;
    feValues<pack, E> many, alike;
    feValues<double, E> one;
    Vec<pack, E::dim> X[E::nNodes], same[E::nNodes];
    typename elements<E>::vec x[packSize][E::nNodes];
    for (int l = 0; l < packSize; ++l)
    {
        this->nodes(x[l], 0.1);
        for (int i = 0; i < E::nNodes; ++i) for (int a = 0; a < E::dim; ++a) X[i][a][l] = x[l][i][a];
    }
    for (int q = 0; q < one.nQ; ++q)
    {
        many.reinit(X, q);
        for (int l = 0; l < packSize; ++l)
        {
            for (int i = 0; i < E::nNodes; ++i) for (int a = 0; a < E::dim; ++a) same[i][a] = x[l][i][a];
            one.reinit(x[l], q);
            alike.reinit(same, q);
            EXPECT_NEAR(many.dV[l], one.dV, 1e-14*std::abs(one.dV));
            EXPECT_EQ(many.dV[l], alike.dV[0]);
            for (int i = 0; i < E::nNodes; ++i) for (int a = 0; a < E::dim; ++a)
            {
                EXPECT_NEAR(many.dN[i][a][l], one.dN[i][a], 1e-13);
                EXPECT_EQ(many.dN[i][a][l], alike.dN[i][a][0]);
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Boundary elements * * * * * * * * * * * * //

namespace
{

//- Distorted face: the integral of n dA over a closed surface is nil, so the
//  face's is fixed by its border. Here: the derivative against differences
template<class F>
void testFace()
{
    constexpr int dim = F::dim + 1;
    std::mt19937 random(3);
    const auto uniform = [&]() { return std::uniform_real_distribution<double>(-1, 1)(random); };
    Vec<double, dim> x[F::nNodes];
    for (int i = 0; i < F::nNodes; ++i)
    {
        for (int a = 0; a < dim; ++a) x[i][a] = (a < F::dim ? F::xi[i][a] : 0) + 0.1*uniform();
    }
    faceValues<double, F> face, plus, minus;
    const double h = 1e-6;
    for (int q = 0; q < face.nQ; ++q)
    {
        face.reinit(x, q);
        for (int j = 0; j < F::nNodes; ++j) for (int b = 0; b < dim; ++b)
        {
            const double xjb = x[j][b];
            x[j][b] = xjb + h;
            plus.reinit(x, q);
            x[j][b] = xjb - h;
            minus.reinit(x, q);
            x[j][b] = xjb;
            const auto d = face.dArea(q, j, b);
            for (int a = 0; a < dim; ++a)
            {
                EXPECT_NEAR(d[a], (plus.ndA[a] - minus.ndA[a])/(2*h), 1e-9) << F::name;
            }
        }
    }
}

} // End anonymous namespace


TEST(faces, derivativeOfTheVectorArea)
{
    testFace<Line1>();
    testFace<Line2>();
    testFace<Tri1>();
    testFace<Tri2>();
    testFace<Quad1>();
    testFace<Quad2>();
}


//- On curved elements: against differences of first derivatives along the reference coordinates
TYPED_TEST(elements, secondDerivatives)
{
    typedef TypeParam E;
    constexpr int dim = E::dim, n = E::nNodes;
    if constexpr (E::order == 2 && dim > 1)
    {
        typedef Vec<double, dim> vec;
        typedef Ten<double, dim> ten;
        vec x[n], u[n];
        this->nodes(x, 0.05);
        for (vec& ui : u) for (int a = 0; a < dim; ++a) ui[a] = this->uniform();

        const auto gradients = [&](const double* xi, vec* dN)
        {
            double N[n], ref[n][dim];
            E::shape(xi, N, ref);
            ten J = ten::zero();
            for (int i = 0; i < n; ++i) for (int a = 0; a < dim; ++a) for (int b = 0; b < dim; ++b)
            {
                J(a, b) += x[i][a]*ref[i][b];
            }
            const ten X = inv(J);
            for (int i = 0; i < n; ++i)
            {
                vec r;
                for (int a = 0; a < dim; ++a) r[a] = ref[i][a];
                dN[i] = r & X;
            }
            return J;
        };

        const auto rule = quadratureOf<E>::make();
        feValues<double, E> w;
        feSecondValues<double, E> second;
        for (int q = 0; q < w.nQ; ++q)
        {
            w.reinit(x, q);
            second.reinit(w, x, q);
            ten d2u[dim], sum[dim];
            second.field(u, w.grad(u), d2u);
            for (ten& s : sum) s = ten::zero();
            vec dN[n], plus[n], minus[n];
            const ten J = gradients(rule.x[q].data(), dN);
            for (int k = 0; k < dim; ++k)
            {
                const double h = 1e-5;
                auto xi = rule.x[q];
                xi[k] += h;
                gradients(xi.data(), plus);
                xi[k] -= 2*h;
                gradients(xi.data(), minus);
                for (int i = 0; i < n; ++i) for (int a = 0; a < dim; ++a)
                {
                    double along = 0;
                    for (int b = 0; b < dim; ++b) along += second.shape(w, i)(a, b)*J(b, k);
                    EXPECT_NEAR(along, (plus[i][a] - minus[i][a])/(2*h), 1e-7);
                }
            }
            for (int i = 0; i < n; ++i) for (int a = 0; a < dim; ++a) sum[a] += u[i][a]*second.shape(w, i);
            for (int a = 0; a < dim; ++a) for (int b = 0; b < dim; ++b) for (int c = 0; c < dim; ++c)
            {
                EXPECT_NEAR(d2u[a](b, c), sum[a](b, c), 1e-12);
            }
        }
    }
}


// ************************************************************************* //
