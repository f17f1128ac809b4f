/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Tests of flowKernel on single elements; its tangents are tested in
    tests/tangent/flowKernel.
\*---------------------------------------------------------------------------*/

#include "flowElements.H"
#include <memory>

using namespace Foam;

namespace
{

template<class E>
struct flowElementTest : ::testing::Test
{
    typedef typename E::V V;
    typedef typename E::P P;
    static constexpr int dim = E::dim;

    std::unique_ptr<typename E::kernel> kernel = std::make_unique<typename E::kernel>();
    std::unique_ptr<typename E::nodes> nodes = std::make_unique<typename E::nodes>();
    typename E::residual R;
};

TYPED_TEST_SUITE(flowElementTest, flowElements, flowElementNames);

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

//- However the nodes lie and whatever their velocity
TYPED_TEST(flowElementTest, uniformFlowStaysUniform)
{
    typedef TypeParam E;
    auto k = E::constants(0.6);
    for (int a = 0; a < E::dim; ++a) k.g[a] = 0;
    E::random(*this->nodes, 1);
    for (int i = 0; i < E::V::nNodes; ++i) for (int a = 0; a < E::dim; ++a)
    {
        this->nodes->v[i][a] = 3 - 2*a;
        this->nodes->a[i][a] = 0;
    }
    for (int i = 0; i < E::P::nNodes; ++i) this->nodes->p[i] = this->nodes->q[i] = 0;

    this->kernel->residual(k, *this->nodes, this->R);
    for (int i = 0; i < E::V::nNodes; ++i) for (int a = 0; a < E::dim; ++a)
    {
        EXPECT_NEAR(this->R.u[i][a], 0, 1e-12);
    }
    for (int i = 0; i < E::P::nNodes; ++i) EXPECT_NEAR(this->R.p[i], 0, 1e-12);
}


//- Forces of an element on all its nodes: those of its inertia and weight;
//  surfaces' stresses are inner forces
TYPED_TEST(flowElementTest, momentumIsConserved)
{
    typedef TypeParam E;
    auto k = E::constants(0.6);
    E::random(*this->nodes, 2);
    this->kernel->residual(k, *this->nodes, this->R);

    feValues<double, typename E::V> w;
    Vec<double, E::dim> force = Vec<double, E::dim>::zero(), exact = force;
    for (int i = 0; i < E::V::nNodes; ++i) force += this->R.u[i];
    for (int q = 0; q < w.nQ; ++q)
    {
        w.reinit(this->nodes->x, q);
        const auto c = w.value(this->nodes->v) - w.value(this->nodes->vm);
        exact += (k.rho*w.dV)*(w.value(this->nodes->a) + (w.grad(this->nodes->v) & c) - k.g);
    }
    for (int a = 0; a < E::dim; ++a) EXPECT_NEAR(force[a], exact[a], 1e-13);
}


//- The sum of the continuity equations is that without stabilisation, too
TYPED_TEST(flowElementTest, volumeIsConserved)
{
    typedef TypeParam E;
    E::random(*this->nodes, 3);
    this->kernel->residual(E::constants(0), *this->nodes, this->R);

    feValues<double, typename E::V> w;
    double flux = 0, exact = 0;
    for (int i = 0; i < E::P::nNodes; ++i) flux += this->R.p[i];
    for (int q = 0; q < w.nQ; ++q)
    {
        w.reinit(this->nodes->x, q);
        exact += tr(w.grad(this->nodes->v))*w.dV;
    }
    EXPECT_NEAR(flux, exact, 1e-13);
}


//- Poiseuille's, which an element of order 2 holds: its strong residual has the viscous term
TYPED_TEST(flowElementTest, parabolaHasNoStrongResidual)
{
    typedef TypeParam E;
    if constexpr (E::V::order == 2)
    {
        auto k = E::constants(0);
        E::random(*this->nodes, 4);
        auto& n = *this->nodes;
        for (int i = 0; i < E::V::nNodes; ++i) for (int a = 0; a < E::dim; ++a)
        {
            n.x[i][a] = E::V::xi[i][a];
            for (int b = 0; b < E::dim; ++b) n.x[i][a] += 0.1*(a + 2*b)*E::V::xi[i][b];
            n.a[i][a] = k.g[a];
        }
        for (int i = 0; i < E::V::nNodes; ++i)
        {
            n.v[i] = Vec<double, E::dim>::zero();
            n.v[i][0] = n.x[i][1]*n.x[i][1];
            n.vm[i] = n.v[i];
        }
        for (int i = 0; i < E::P::nNodes; ++i) n.p[i] = 2*k.mu*n.x[i][0];
        this->kernel->residual(k, n, this->R);
        for (int i = 0; i < E::P::nNodes; ++i) EXPECT_NEAR(this->R.p[i], 0, 1e-13);
    }
}


//- Lanes of a pack are elements of their own
TYPED_TEST(flowElementTest, aPackIsSeveralDoubles)
{
    typedef TypeParam E;
    typedef typename E::V V;
    typedef typename E::P P;
    const auto k = E::constants(0.6);
    const auto many = std::make_unique<flowNodes<pack, V, P>>();
    std::vector<typename E::nodes> one(packSize);
    for (int l = 0; l < packSize; ++l)
    {
        E::random(one[l], 20 + l);
        for (int i = 0; i < V::nNodes; ++i) for (int a = 0; a < E::dim; ++a)
        {
            many->x[i][a][l] = one[l].x[i][a];
            many->v[i][a][l] = one[l].v[i][a];
            many->a[i][a][l] = one[l].a[i][a];
            many->vm[i][a][l] = one[l].vm[i][a];
        }
        for (int q = 0; q < feValues<double, V>::nQ; ++q) for (int a = 0; a < E::dim; ++a)
        {
            many->s[q][a][l] = one[l].s[q][a];
        }
        many->widest2[l] = one[l].widest2;
        for (int i = 0; i < P::nNodes; ++i)
        {
            many->p[i][l] = one[l].p[i];
            many->q[i][l] = one[l].q[i];
        }
    }

    const auto kernel = std::make_unique<flowKernel<pack, V, P, E::stabilised, E::general>>();
    const auto R = std::make_unique<flowResidual<pack, V, P>>();
    const auto K = std::make_unique<flowTangent<pack, V, P>>();
    const auto K1 = std::make_unique<typename E::tangent>();
    kernel->residual(k, *many, *R);
    kernel->tangent(k, *many, *K);
    kernel->shapeTangent(k, *many, *K);
    for (int l = 0; l < packSize; ++l)
    {
        this->kernel->residual(k, one[l], this->R);
        this->kernel->tangent(k, one[l], *K1);
        this->kernel->shapeTangent(k, one[l], *K1);
        EXPECT_NEAR(R->minDetJ[l], this->R.minDetJ, 1e-14);
        double error = 0;
        const auto compare = [&](const pack& a, const double b) { error = std::max(error, std::abs(a[l] - b)); };
        for (int i = 0; i < V::nNodes; ++i) for (int a = 0; a < E::dim; ++a)
        {
            compare(R->u[i][a], this->R.u[i][a]);
            for (int j = 0; j < V::nNodes; ++j) for (int b = 0; b < E::dim; ++b)
            {
                compare(K->uu[i][j](a, b), K1->uu[i][j](a, b));
                compare(K->um[i][j](a, b), K1->um[i][j](a, b));
            }
            for (int j = 0; j < P::nNodes; ++j)
            {
                compare(K->up[i][j][a], K1->up[i][j][a]);
                compare(K->pu[j][i][a], K1->pu[j][i][a]);
                compare(K->pm[j][i][a], K1->pm[j][i][a]);
            }
        }
        for (int i = 0; i < P::nNodes; ++i)
        {
            compare(R->p[i], this->R.p[i]);
            for (int j = 0; j < P::nNodes; ++j) compare(K->pp[i][j], K1->pp[i][j]);
        }
        EXPECT_LT(error, 1e-12);
    }
}


//- Of laminar flows between walls only Smagorinsky's viscosity is not nil; its
//  filter has the width of the element, or less where it has a largest one
TEST(eddyViscosity, pureShear)
{
    flowConstants<3> k;
    k.C2 = 0.01;
    Ten<double, 3> L = Ten<double, 3>::zero();
    L(0, 1) = 5;
    eddyViscosity<double, Hex1> eddy;
    k.eddy = eddyModel::WALE;
    eddy.reinit(k, L, 1, 0);
    EXPECT_LT(eddy.nut, 1e-12);

    // Volume 8, rate 5
    k.eddy = eddyModel::SMAGORINSKY;
    eddy.reinit(k, L, 1, 0);
    EXPECT_NEAR(eddy.nut, 0.01*4*5, 1e-12);
    k.damped = true;
    eddy.reinit(k, L, 1, 0.09);
    EXPECT_NEAR(eddy.nut, 0.01*0.09*5, 1e-12);
    eddy.reinit(k, L, 1, 9);
    EXPECT_NEAR(eddy.nut, 0.01*4*5, 1e-12);
}


// ************************************************************************* //
