/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Tests of flowAssembly on small meshes in memory.
\*---------------------------------------------------------------------------*/

#include "flowMesh.H"
#include <gtest/gtest.h>
#include <omp.h>

using namespace Foam;

namespace
{

struct meshKind
{
    const char* cell;
    label order;
    bool plane;
};

const meshKind kinds[] =
{
    {"prism", 1, true}, {"hex", 1, true}, {"prism", 2, true}, {"hex", 2, true},
    {"tet", 1, false}, {"hex", 1, false}, {"prism", 1, false}, {"pyr", 1, false},
    {"tet", 2, false}, {"hex", 2, false}
};

//- Call f(mesh) for all of them, those of order 2 with and without stabilisation
template<class F>
void forMeshes(const shapeMesh::pointMap& map, const F& f)
{
    for (const meshKind& m : kinds) for (const bool stabilised : {true, false})
    {
        if (m.order == 1 && !stabilised) continue;
        SCOPED_TRACE
        (
            std::string(m.cell) + " of order " + std::to_string(m.order)
          + (m.plane ? ", plane" : "") + (stabilised ? ", stabilised" : "")
        );
        flowMesh mesh(m.cell, {3, 3, m.plane ? 1 : 2}, m.order, m.plane, map);
        mesh.k.stabilised = stabilised;
        f(mesh);
    }
}

scalar norm(const scalarField& f) { return ::sqrt(sumSqr(f)); }

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

//- Uniform velocity and pressure on an arbitrarily moving mesh
TEST(flowAssembly, uniformFlowStaysUniform)
{
    forMeshes(flowMesh::distorted, [](flowMesh& m)
    {
        m.randomise(0.01);
        const vector v(1, -0.5, m.fe.dim() == 2 ? 0 : 0.7);
        m.fields.v = v;
        m.fields.a = Zero;
        m.fields.p = 3;
        m.fields.q = 0;
        m.k.rBulk = 0.3;
        EXPECT_GT(m.assemble(), 0);
        for (const label n : m.interior()) EXPECT_LT(mag(m.Ru[n]), 1e-12);
        EXPECT_LT(max(mag(m.Rp)), 1e-12);
    });
}


//- At rest under its own weight
TEST(flowAssembly, hydrostaticPressureBalancesWeight)
{
    forMeshes(flowMesh::distorted, [](flowMesh& m)
    {
        m.k.g = vector(0.5, -9.81, m.fe.dim() == 2 ? 0 : 1);
        forAll(m.fields.p, n) m.fields.p[n] = m.k.rho*(m.k.g & m.fe.points()[n]);
        m.assemble();
        for (const label n : m.interior()) EXPECT_LT(mag(m.Ru[n]), 1e-12);
        EXPECT_LT(max(mag(m.Rp)), 1e-12);
    });
}


//- v = y(1 - y), p = -2 mu x belongs to Taylor-Hood elements with affine maps
TEST(flowAssembly, poiseuilleFlowIsExact)
{
    const auto affine = [](const point& p) { return point(2*p.x() + 0.3*p.y(), p.y(), p.z() + 0.2*p.x()); };
    forMeshes(affine, [](flowMesh& m)
    {
        if (m.fe.order() == 1 || m.k.stabilised) return;
        forAll(m.fields.v, n)
        {
            const point& x = m.fe.points()[n];
            m.fields.v[n] = vector(x.y()*(1 - x.y()), 0, 0);
            if (n < m.fe.nVertices()) m.fields.p[n] = -2*m.k.mu*x.x();
        }
        m.assemble();
        for (const label n : m.interior()) EXPECT_LT(mag(m.Ru[n]), 1e-14);
        EXPECT_LT(max(mag(m.Rp)), 1e-14);
    });
}


//- K and S times an increment against central differences, through the scatter
TEST(flowAssembly, matricesAreDerivatives)
{
    forMeshes(flowMesh::distorted, [](flowMesh& m)
    {
        m.randomise(0.002);
        m.k.rBulk = 0.4;
        feMatrix K(m.rows, m.rows, nullptr, m.scatter), S(m.rows, m.columns, nullptr, m.shapeScatter);
        flowMatrices to;
        to.K = &K;
        to.S = &S;
        to.scatter = &m.scatter;
        to.shapeScatter = &m.shapeScatter;
        to.columns = 0.7;
        to.heldNodes = boolList(m.fe.nNodes(), false);
        to.heldNodes[1] = to.heldNodes[4] = true;
        EXPECT_GT(m.assemble(&to), 0);

        Foam::Random random(5);
        scalarField dx(m.rows.nUnknowns()), dm(m.columns.nUnknowns());
        for (scalar& s : dx) s = random.GaussNormal<scalar>();
        for (scalar& s : dm) s = random.GaussNormal<scalar>();
        scalarField Kdx(m.rows.nUnknowns()), Sdm(Kdx);
        K.multiply(dx, Kdx);
        S.multiply(dm, Sdm);

        const auto move = [&](const scalar flow, const scalar mesh)
        {
            forAll(m.fields.v, n)
            {
                const vector dv = to.heldNodes[n] ? vector(Zero) : flow*m.flow.at(0, n, dx);
                const vector dX = mesh*m.shape.at(0, n, dm);
                m.fields.v[n] += dv;
                m.fields.a[n] += m.k.dadv*dv;
                m.fields.x[n] += dX;
                m.fields.vm[n] += m.k.dvmdm*dX;
                if (n >= m.fe.nVertices()) continue;
                const scalar dp = flow*dx[m.flow.start(1, n)];
                m.fields.p[n] += dp;
                m.fields.q[n] += m.k.dqdp*dp;
            }
        };
        const auto difference = [&](const scalar flow, const scalar mesh)
        {
            const scalar h = 1e-6;
            move(h*flow, h*mesh);
            const scalarField plus(m.residual());
            move(-2*h*flow, -2*h*mesh);
            const scalarField minus(m.residual());
            move(h*flow, h*mesh);
            return scalarField((0.5/h)*(plus - minus));
        };
        EXPECT_LT(norm(Kdx - to.columns*difference(1, 0)), 1e-6*norm(Kdx));
        EXPECT_LT(norm(Sdm - to.columns*difference(0, 1)), 1e-6*norm(Sdm));
    });
}


TEST(flowAssembly, threadsDoNotChangeABit)
{
    const int nThreads = omp_get_max_threads();
    forMeshes(flowMesh::distorted, [](flowMesh& m)
    {
        m.randomise(0.002);
        List<vectorField> Ru(3);
        List<scalarField> values(3);
        for (int n = 1; n <= 3; ++n)
        {
            omp_set_num_threads(n);
            feMatrix K(m.rows, m.rows, nullptr, m.scatter);
            flowMatrices to;
            to.K = &K;
            to.scatter = &m.scatter;
            m.assemble(&to);
            Ru[n - 1] = m.Ru;
            labelList row, col;
            K.triplets(row, col);
            K.values(values[n - 1]);
        }
        EXPECT_EQ(Ru[0], Ru[1]);
        EXPECT_EQ(Ru[0], Ru[2]);
        EXPECT_EQ(values[0], values[1]);
        EXPECT_EQ(values[0], values[2]);
    });
    omp_set_num_threads(nThreads);
}


TEST(flowAssembly, tellsTheSmallestDeterminant)
{
    forMeshes(flowMesh::distorted, [](flowMesh& m)
    {
        EXPECT_GT(m.assemble(), 0);

        // An interior vertex through the opposite faces
        for (const label n : m.interior())
        {
            if (n < m.fe.nVertices()) m.fields.x[n] += vector(0.9, 0, 0);
        }
        EXPECT_LT(m.assemble(), 0);
    });
}


// ************************************************************************* //
