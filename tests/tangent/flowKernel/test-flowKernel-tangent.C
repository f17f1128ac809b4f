/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    test-flowKernel-tangent

Description
    All six blocks of flowKernel's tangents against central differences of its
    residual: every pair of elements, incompressible and barotropic, with each
    viscosity, density and stabilisation.
\*---------------------------------------------------------------------------*/

#include "flowElements.H"
#include <memory>

using namespace Foam;

namespace
{

//- Norms of a block and of its difference from central differences
struct comparison
{
    double error = 0, size = 0;

    void add(const double exact, const double difference)
    {
        error += (exact - difference)*(exact - difference);
        size += exact*exact;
    }

    void expectAgreement(const char* block) const
    {
        EXPECT_LE(std::sqrt(error), 1e-6*std::sqrt(size) + 1e-12) << block;
    }
};


template<class E>
class flowTangents : public ::testing::Test
{
    typedef typename E::V V;
    typedef typename E::P P;
    static constexpr int dim = E::dim;

    typename E::kernel kernel;
    typename E::residual plus, minus;

    //- d R by a change of some numbers of n, each with its rate
    struct change
    {
        double* value;
        double rate;
    };

    void difference(const flowConstants<dim>& k, typename E::nodes& n, std::initializer_list<change> changes)
    {
        const double h = 1e-5;
        const auto move = [&](const double step)
        {
            for (const change& c : changes) *c.value += c.rate*step;
        };
        move(h);
        kernel.residual(k, n, plus);
        move(-2*h);
        kernel.residual(k, n, minus);
        move(h);
        for (int i = 0; i < V::nNodes; ++i) plus.u[i] = (0.5/h)*(plus.u[i] - minus.u[i]);
        for (int i = 0; i < P::nNodes; ++i) plus.p[i] = (0.5/h)*(plus.p[i] - minus.p[i]);
    }

public:

    void test(const double rBulk)
    {
        for (const flowVariant<E>& variant : flowVariants<E>())
        {
            SCOPED_TRACE(variant.name);
            auto k = E::constants(rBulk);
            variant.set(k);
            test(k);
        }
    }

    void test(const flowConstants<dim>& k)
    {
        auto n = std::make_unique<typename E::nodes>();
        auto K = std::make_unique<typename E::tangent>();
        for (int trial = 0; trial < 3; ++trial)
        {
            E::random(*n, 10 + trial);
            kernel.residual(k, *n, plus);
            ASSERT_GT(plus.minDetJ, 0);
            kernel.tangent(k, *n, *K);
            kernel.shapeTangent(k, *n, *K);

            comparison uu, up, pu, pp, um, pm;
            for (int j = 0; j < V::nNodes; ++j) for (int b = 0; b < dim; ++b)
            {
                difference(k, *n, {{&n->v[j][b], 1}, {&n->a[j][b], k.dadv}});
                for (int i = 0; i < V::nNodes; ++i) for (int a = 0; a < dim; ++a) uu.add(K->uu[i][j](a, b), plus.u[i][a]);
                for (int i = 0; i < P::nNodes; ++i) pu.add(K->pu[i][j][b], plus.p[i]);

                difference(k, *n, {{&n->x[j][b], 1}, {&n->vm[j][b], k.dvmdm}});
                for (int i = 0; i < V::nNodes; ++i) for (int a = 0; a < dim; ++a) um.add(K->um[i][j](a, b), plus.u[i][a]);
                for (int i = 0; i < P::nNodes; ++i) pm.add(K->pm[i][j][b], plus.p[i]);
            }
            for (int j = 0; j < P::nNodes; ++j)
            {
                difference(k, *n, {{&n->p[j], 1}, {&n->q[j], k.dqdp}});
                for (int i = 0; i < V::nNodes; ++i) for (int a = 0; a < dim; ++a) up.add(K->up[i][j][a], plus.u[i][a]);
                for (int i = 0; i < P::nNodes; ++i) pp.add(K->pp[i][j], plus.p[i]);
            }
            uu.expectAgreement("uu");
            up.expectAgreement("up");
            pu.expectAgreement("pu");
            pp.expectAgreement("pp");
            um.expectAgreement("um");
            pm.expectAgreement("pm");
            EXPECT_GT(uu.size*up.size*pu.size*um.size*pm.size, 0);
            EXPECT_EQ(pp.size > 0, k.rB > 0 || (E::stabilised && P::order > 0));
        }
    }
};

TYPED_TEST_SUITE(flowTangents, flowElements, flowElementNames);

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TYPED_TEST(flowTangents, incompressible) { this->test(0); }
TYPED_TEST(flowTangents, barotropic) { this->test(0.6); }


int main(int argc, char* argv[])
{
    ::testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}


// ************************************************************************* //
