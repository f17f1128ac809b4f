/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Tests of dofConstraints and feMatrix.
\*---------------------------------------------------------------------------*/

#include "shapeMesh.H"
#include "feMesh.H"
#include "feMatrix.H"
#include "Random.H"
#include <Eigen/Dense>
#include <gtest/gtest.h>
#include <omp.h>

using namespace Foam;

namespace
{

typedef dofConstraints::term term;
typedef Eigen::MatrixXd matrix;

matrix transformation(const dofConstraints& c)
{
    matrix T = matrix::Zero(c.size(), c.size());
    for (label i = 0; i < c.size(); ++i)
    {
        if (c.isFree(i)) T(i, i) = 1;
        if (c.isTied(i)) for (const term& t : c.masters(i)) T(i, t.unknown) += t.weight;
    }
    return T;
}

scalarField randomField(const label n, const label seed)
{
    Foam::Random random(seed);
    scalarField f(n);
    for (scalar& s : f) s = random.GaussNormal<scalar>();
    return f;
}

Eigen::Map<const Eigen::VectorXd> map(const scalarField& f)
{
    return Eigen::Map<const Eigen::VectorXd>(f.cdata(), f.size());
}

std::string complaint(dofConstraints& c)
{
    const bool throwing = FatalError.throwExceptions();
    std::string message;
    try { c.close(); }
    catch (const Foam::error& error) { message = error.message(); }
    FatalError.throwExceptions(throwing);
    return message;
}


//- A mesh with three unknowns at vertices, two at other nodes, and random
//  matrices of its elements
struct randomSystem
{
    shapeMesh box;
    feMesh fe;
    nodeMap rows;
    PtrList<elementScatter> scatter;

    static labelList counts(const feMesh& fe)
    {
        labelList n(fe.nNodes(), 2);
        for (label i = 0; i < fe.nVertices(); ++i) n[i] = 3;
        return n;
    }

    randomSystem()
    :
        box("hex", {3, 3, 1}, [](const point& p) { return p; }, shapeMesh::twoD()),
        fe(box.mesh(), 2, dictionary()),
        rows(identity(fe.nNodes()), counts(fe))
    {
        scatter.append(new elementScatter(fe.blocks()[0], identity(fe.nNodes()), identity(fe.nNodes())));
    }

    //- Vector-vector blocks of all 9 nodes, and vector-scalar ones
    void fill(feMatrix& K)
    {
        const elementBlock& block = fe.blocks()[0];
        K.clear();
        #pragma omp parallel
        {
            std::vector<pack> uu(9*9*4), up(9*4*2);
            block.forBatches([&](const label batch)
            {
                for (int l = 0; l < packSize; ++l)
                {
                    Foam::Random random(block.lane(batch, l) + 1);
                    for (pack& k : uu) k[l] = random.GaussNormal<scalar>();
                    for (pack& k : up) k[l] = random.GaussNormal<scalar>();
                }
                K.add(scatter[0], block, batch, uu.data(), 9, 9, 2, 2, 0, 0, 1);
                K.add(scatter[0], block, batch, up.data(), 9, 4, 2, 1, 0, 2, 0.5);
            });
        }
    }

    //- The same, entry by entry
    matrix dense()
    {
        const elementBlock& block = fe.blocks()[0];
        matrix K = matrix::Zero(rows.nUnknowns(), rows.nUnknowns());
        for (label e = 0; e < block.size(); ++e)
        {
            Foam::Random random(e + 1);
            const label* n = block.element(e);
            for (int i = 0; i < 9; ++i) for (int j = 0; j < 9; ++j) for (int a = 0; a < 2; ++a) for (int b = 0; b < 2; ++b)
            {
                K(rows.start(n[i]) + a, rows.start(n[j]) + b) += random.GaussNormal<scalar>();
            }
            for (int i = 0; i < 9; ++i) for (int j = 0; j < 4; ++j) for (int a = 0; a < 2; ++a)
            {
                K(rows.start(n[i]) + a, rows.start(n[j]) + 2) += 0.5*random.GaussNormal<scalar>();
            }
        }
        return K;
    }

    matrix multiplied(const feMatrix& K) const
    {
        matrix A(rows.nUnknowns(), rows.nUnknowns());
        scalarField x(rows.nUnknowns(), 0), y(x);
        forAll(x, j)
        {
            x[j] = 1;
            K.multiply(x, y);
            A.col(j) = map(y);
            x[j] = 0;
        }
        return A;
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(dofConstraints, closesChains)
{
    dofConstraints c(7);
    c.tie(0, List<term>({{1, 2.0}}));
    c.tie(1, List<term>({{2, 0.5}, {3, 3.0}, {4, 1.0}}));
    c.tie(4, List<term>({{5, -1.0}, {2, 4.0}}));
    c.fix(3);
    c.tie(6, List<term>({{3, 1.0}}));
    c.close();

    const matrix T = transformation(c);
    EXPECT_TRUE(c.isTied(0) && c.isTied(1) && c.isTied(4));
    EXPECT_EQ(T(0, 2), 2*(0.5 + 4));
    EXPECT_EQ(T(0, 5), -2);
    EXPECT_EQ(T(1, 2), 4.5);
    EXPECT_EQ(T.col(3).norm(), 0);

    // All of its masters are fixed: so is it
    EXPECT_TRUE(c.isFixed(6));
    EXPECT_TRUE(c.isFree(2));
}


TEST(dofConstraints, theLastWordCounts)
{
    dofConstraints c(3);
    c.tie(0, List<term>({{1, 1.0}}));
    c.tie(0, List<term>({{2, 5.0}}));
    c.tie(1, List<term>({{2, 1.0}}));
    c.fix(1);
    c.close();
    EXPECT_EQ(transformation(c)(0, 2), 5);
    EXPECT_TRUE(c.isFixed(1));
}


TEST(dofConstraints, complainsOfCycles)
{
    dofConstraints self(2), three(4), tail(4);
    self.tie(0, List<term>({{0, 0.5}, {1, 1.0}}));
    EXPECT_NE(complaint(self).find("refers to itself"), std::string::npos);

    three.tie(0, List<term>({{1, 0.5}}));
    three.tie(1, List<term>({{2, 0.5}}));
    three.tie(2, List<term>({{0, 0.5}}));
    EXPECT_NE(complaint(three).find("refers to itself"), std::string::npos);

    // A cycle that is met from outside
    tail.tie(0, List<term>({{1, 0.5}}));
    tail.tie(1, List<term>({{2, 1.0}}));
    tail.tie(2, List<term>({{1, 1.0}, {3, 1.0}}));
    EXPECT_NE(complaint(tail).find("refers to itself"), std::string::npos);
}


TEST(dofConstraints, condenseIsTheTransposeOfDistribute)
{
    dofConstraints c(20);
    c.tie(3, List<term>({{4, 0.7}, {5, -1.2}}));
    c.tie(4, List<term>({{10, 2.0}, {3 + 9, 0.1}}));
    c.fix(5);
    c.fix(17);
    c.tie(19, List<term>({{0, 1.0}}));
    c.close();
    const matrix T = transformation(c);

    const scalarField x0(randomField(20, 1)), r0(randomField(20, 2));
    scalarField x(x0), r(r0);
    c.distribute(x);
    c.condense(r);
    EXPECT_LT((map(x) - T*map(x0)).norm(), 1e-15);
    EXPECT_LT((map(r) - T.transpose()*map(r0)).norm(), 1e-15);
    EXPECT_NEAR(sumProd(x, r0), sumProd(x0, r), 1e-14);
}


TEST(feMatrix, isTheSumOfItsElements)
{
    randomSystem s;
    feMatrix K(s.rows, s.rows, nullptr, s.scatter);
    s.fill(K);
    const matrix A = s.dense();
    EXPECT_LT((s.multiplied(K) - A).norm(), 1e-13*A.norm());
    for (label u = 0; u < s.rows.nUnknowns(); ++u) EXPECT_NEAR(K.diagonal(u), A(u, u), 1e-13);

    // Times a vector
    const scalarField x(randomField(s.rows.nUnknowns(), 3));
    scalarField y(x.size());
    K.multiply(x, y);
    EXPECT_LT((map(y) - A*map(x)).norm(), 1e-13*map(y).norm());

    K.add(0, 1, s.fe.blocks()[0].element(0)[0], 0, 2.5);
    scalarField z(x.size());
    K.multiply(x, z);
    z -= y;
    EXPECT_NEAR(z[s.rows.start(0) + 1], 2.5*x[s.rows.start(s.fe.blocks()[0].element(0)[0])], 1e-13);
}


TEST(feMatrix, threadsDoNotChangeABit)
{
    randomSystem s;
    const int nThreads = omp_get_max_threads();
    List<scalarField> v(3);
    for (int n = 1; n <= 3; ++n)
    {
        omp_set_num_threads(n);
        feMatrix K(s.rows, s.rows, nullptr, s.scatter);
        s.fill(K);
        labelList row, col;
        K.triplets(row, col);
        K.values(v[n - 1]);
    }
    omp_set_num_threads(nThreads);
    EXPECT_EQ(v[0], v[1]);
    EXPECT_EQ(v[0], v[2]);
}


TEST(feMatrix, constraintsAreEliminated)
{
    randomSystem s;
    const label n = s.rows.nUnknowns();
    dofConstraints c(n);
    c.tie(s.rows.start(5), List<term>({{s.rows.start(5) + 1, -0.4}}));
    c.tie(s.rows.start(7) + 1, List<term>({{s.rows.start(2), 1.5}, {s.rows.start(20), 0.5}}));
    c.tie(s.rows.start(20), List<term>({{s.rows.start(31) + 1, 2.0}}));
    c.fix(s.rows.start(9));
    c.fix(s.rows.start(9) + 1);
    c.close();

    feMatrix K(s.rows, s.rows, &c, s.scatter);
    s.fill(K);
    const matrix T = transformation(c), A = T.transpose()*s.dense()*T;

    // Rows and columns of free unknowns, and one for each other
    labelList row, col;
    scalarField value;
    K.triplets(row, col);
    K.values(value);
    matrix B = matrix::Zero(n, n);
    forAll(value, k) B(row[k], col[k]) += value[k];
    for (label u = 0; u < n; ++u) if (!c.isFree(u)) { EXPECT_EQ(B(u, u), 1); B(u, u) = 0; }
    EXPECT_LT((A - B).norm(), 1e-13*A.norm());

    // The product with an increment, on the rows of free unknowns
    scalarField x(randomField(n, 4)), y(n);
    c.distribute(x);
    K.multiply(x, y);
    const Eigen::VectorXd exact = T.transpose()*(s.dense()*map(x));
    for (label u = 0; u < n; ++u) EXPECT_NEAR(c.isFree(u) ? y[u] - exact[u] : 0, 0, 1e-12);

    // Terms of the boundary take the same way
    K.clear();
    K.add(7, 1, 7, 1, 2);
    K.multiply(x, y);
    scalarField r(n, 0);
    r[s.rows.start(7) + 1] = 2*x[s.rows.start(7) + 1];
    c.condense(r);
    forAll(r, u) EXPECT_NEAR(y[u], r[u], 1e-14);
}


// ************************************************************************* //
