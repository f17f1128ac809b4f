/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Tests of feMatrix, on one rank and on several, against dense matrices.
\*---------------------------------------------------------------------------*/

#include "shapeMesh.H"
#include "decomposedCase.H"
#include "denseConstraints.H"
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

//- A mesh with three unknowns at vertices, two at other nodes, and random
//  matrices of its elements
struct randomSystem
{
    shapeMesh box;
    feMesh fe;
    fieldLayout layout;
    nodeMap rows;
    fieldUnknowns unknowns;
    PtrList<elementScatter> scatter;

    static List<fieldLayout::field> fields()
    {
        return
        {
            {"u", fieldLayout::kind::VECTOR, fieldLayout::support::NODES, dimless},
            {"p", fieldLayout::kind::SCALAR, fieldLayout::support::VERTICES, dimless}
        };
    }

    randomSystem()
    :
        box("hex", {3, 3, 1}, [](const point& p) { return p; }, shapeMesh::twoD()),
        fe(box.mesh(), 2, dictionary()),
        layout(fe, fields()),
        rows(layout.keys(), fieldUnknowns::counts(layout)),
        unknowns(layout, rows)
    {
        scatter.append(new elementScatter(fe.blocks()[0], unknowns));
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
                K.add(scatter[0], block, batch, uu.data(), 0, 0, 1);
                K.add(scatter[0], block, batch, up.data(), 0, 1, 0.5);
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

//- A mesh on some ranks with a vector at the nodes and a scalar in the cells,
//  constraints between nodes and cells of any ranks, and random matrices
struct randomSystemOnRanks
{
    decomposedCase box;
    feMesh fe;
    fieldLayout layout;
    nodeMap map;
    fieldUnknowns unknowns;
    PtrList<elementScatter> scatter;
    dofConstraints c;
    denseConstraints reference;

    static List<fieldLayout::field> fields()
    {
        return
        {
            {"u", fieldLayout::kind::VECTOR, fieldLayout::support::NODES, dimless},
            {"s", fieldLayout::kind::SCALAR, fieldLayout::support::CELLS, dimless}
        };
    }

    randomSystemOnRanks()
    :
        box("scatteredBox", "quad 4 " + std::to_string(Pstream::nProcs())),
        fe(box.mesh(), 2, dictionary()),
        layout(fe, fields()),
        map(layout.keys(), fieldUnknowns::counts(layout)),
        unknowns(layout, map),
        c(map),
        reference(map.numbering().size())
    {
        constrain();
        for (const elementBlock& block : fe.blocks()) scatter.append(new elementScatter(block, unknowns));
    }

    //- First global unknown of each node of all ranks, and its place
    void gatherNodes(labelList& start, vectorField& X) const
    {
        labelList mine;
        vectorField points;
        for (const label n : map.ownedNodes())
        {
            if (n >= fe.nNodes()) continue;
            mine.append(map.global(map.start(n)));
            points.append(fe.points()[n]);
        }
        start = gatherAll<label>(mine);
        X = gatherAll<vector>(points);
    }

    //- The left side follows the right one, a node in the middle the left side;
    //  the first cell of a rank follows that of the next one, with a node; the
    //  top and a node of the right are given
    void constrain()
    {
        labelList start;
        vectorField X;
        gatherNodes(start, X);
        const auto nearest = [&](const point& x)
        {
            label best = 0;
            forAll(X, i) if (magSqr(X[i] - x) < magSqr(X[best] - x)) best = i;
            return start[best];
        };
        const auto tie = [&](const label g, const std::vector<std::pair<label, scalar>>& masters, const scalar b)
        {
            reference.tie(g, masters, b);
            if (map.local(g) < 0) return;
            List<term> terms;
            for (const auto& m : masters) terms.append(term{m.first, m.second});
            c.tieGlobal(map.local(g), terms, b);
        };
        const auto fix = [&](const label g)
        {
            reference.fix(g);
            if (map.local(g) >= 0) c.fix(map.local(g));
        };

        const scalar z = X[0].z();
        forAll(X, i)
        {
            const bool left = mag(X[i].x()) < 1e-10, right = mag(X[i].x() - 1) < 1e-10;
            const label opposite = nearest(point(1, X[i].y(), z));
            if (left) tie(start[i], {{opposite, 0.6}, {opposite + 1, -0.3}}, X[i].y() + 1);
            if (mag(X[i].y() - 1) < 1e-10 && !left && !right) { fix(start[i]); fix(start[i] + 1); }
        }
        fix(nearest(point(1, 0.5, z)) + 1);
        tie(nearest(point(0.5, 0.5, z)) + 1, {{nearest(point(0, 0.5, z)), 2}}, -0.7);

        // Cells: one unknown each, of which the first one of each rank
        const label mine = fe.mesh().nCells() ? map.global(unknowns.start(1, 0)) : -1;
        const labelList first(gatherAll<label>(labelList(1, mine)));
        forAll(first, rank)
        {
            const label other = nearest(point(1, 0.25, z));
            if (rank + 1 < first.size()) tie(first[rank], {{first[rank + 1], 0.5}, {other, 1.5}}, rank);
            else tie(first[rank], {{other, 1.5}}, 0.2);
        }
        c.close();
        reference.close();
    }

    //- As feRegion does
    void colour(const feMatrix& K)
    {
        labelHashSet masters;
        List<List<labelList>> nodes(scatter.size());
        forAll(scatter, b)
        {
            nodes[b] = K.constrainedNodes(scatter[b]);
            for (const labelList& m : nodes[b]) masters.insert(m);
        }
        forAll(scatter, b)
        {
            const elementScatter& s = scatter[b];
            forAll(nodes[b], e) for (label i = 0; i < s.nRow; ++i)
            {
                const label node = s.rowNodes[e*s.nRow + i];
                if (masters.found(node)) nodes[b][e].append(node);
            }
            fe.blocks()[b].colour(fe.nNodes(), nodes[b], map.nNodes());
        }
    }

    static scalar scale(const label f, const label g) { return 1 + f + 0.5*g; }

    //- Entry of an element matrix; no two alike
    static scalar entry(const label e, const label f, const label g, const label k)
    {
        return ::sin(1.0 + Pstream::myProcNo() + 3.7*e + 11*f + 17*g + 1.3*k);
    }

    void fill(feMatrix& K)
    {
        K.clear();
        forAll(scatter, b)
        {
            const elementBlock& block = fe.blocks()[b];
            const elementScatter& s = scatter[b];
            #pragma omp parallel
            block.forBatches([&](const label batch)
            {
                for (label f = 0; f < 2; ++f) for (label g = 0; g < 2; ++g)
                {
                    std::vector<pack> k(s.rows[f].n*s.rows[f].nCmpts*s.cols[g].n*s.cols[g].nCmpts);
                    for (size_t i = 0; i < k.size(); ++i) for (int l = 0; l < packSize; ++l)
                    {
                        k[i][l] = entry(block.lane(batch, l), f, g, i);
                    }
                    K.add(s, block, batch, k.data(), f, g, scale(f, g));
                }
            });
        }
    }

    //- Sum of the elements of all ranks, without constraints
    matrix dense() const
    {
        const label n = reference.size();
        scalarField all(n*n, 0);
        for (const elementBlock& block : fe.blocks()) for (label e = 0; e < block.size(); ++e)
        {
            // Values of the two fields in the element, by their components
            labelList at[2];
            for (label i = 0; i < block.nNodes; ++i) for (label a = 0; a < fe.dim(); ++a)
            {
                at[0].append(map.global(unknowns.start(0, block.element(e)[i]) + a));
            }
            at[1].append(map.global(unknowns.start(1, block.cells[e])));
            const label size[2] = {fe.dim(), 1};
            for (label f = 0; f < 2; ++f) for (label g = 0; g < 2; ++g)
            {
                label k = 0;
                for (label i = 0; i < at[f].size(); i += size[f]) for (label j = 0; j < at[g].size(); j += size[g])
                {
                    for (label a = 0; a < size[f]; ++a) for (label b = 0; b < size[g]; ++b)
                    {
                        all[at[f][i + a]*n + at[g][j + b]] += scale(f, g)*entry(e, f, g, k++);
                    }
                }
            }
        }
        Pstream::listCombineGather(all, plusEqOp<scalar>());
        Pstream::listCombineScatter(all);
        return Eigen::Map<const Eigen::Matrix<double, -1, -1, Eigen::RowMajor>>(all.cdata(), n, n);
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(feMatrix, isTheSumOfItsElements)
{
    randomSystem s;
    feMatrix K(s.rows, s.rows, nullptr, s.scatter);
    s.fill(K);
    const matrix A = s.dense();
    EXPECT_LT((s.multiplied(K) - A).norm(), 1e-13*A.norm());
    for (label u = 0; u < s.rows.nUnknowns(); ++u)
    {
        scalar sum = 0, expected = 0;
        for (label v = 0; v < s.rows.nUnknowns(); ++v) expected += (v + 1)*A(u, v);
        K.forRow(u, [&](const label v, const scalar entry) { sum += (v + 1)*entry; });
        EXPECT_NEAR(sum, expected, 1e-10);
    }

    // Times a vector
    const scalarField x(randomField(s.rows.nUnknowns(), 3));
    scalarField y(x.size());
    K.multiply(x, y);
    EXPECT_LT((map(y) - A*map(x)).norm(), 1e-13*map(y).norm());

    K.add(s.rows.start(0) + 1, s.rows.start(s.fe.blocks()[0].element(0)[0]), 2.5);
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
    dofConstraints c(s.rows);
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
    K.add(s.rows.start(7) + 1, s.rows.start(7) + 1, 2);
    K.multiply(x, y);
    scalarField r(n, 0);
    r[s.rows.start(7) + 1] = 2*x[s.rows.start(7) + 1];
    c.condense(r);
    forAll(r, u) EXPECT_NEAR(y[u], r[u], 1e-14);
}


TEST(matrixOnRanks, isCondensedAsADenseOne)
{
    randomSystemOnRanks s;
    const label n = s.reference.size();
    const matrix A = s.dense(), C = s.reference.Tf.transpose()*A*s.reference.Tf;

    // Masters are at other nodes, and with several ranks on others
    label nElsewhere = 0;
    for (const label u : s.c.slaves()) for (const term& t : s.c.masters(u))
    {
        nElsewhere += s.map.nodeOf(t.unknown) != s.map.nodeOf(u);
    }
    EXPECT_GT(returnReduce(nElsewhere, sumOp<label>()), 0);
    EXPECT_EQ(returnReduce(s.map.nNodes() - s.layout.nEntities(), sumOp<label>()) > 0, Pstream::parRun());

    const int nThreads = omp_get_max_threads();
    List<scalarField> values(3), products(3);
    const Eigen::VectorXd x0 = Eigen::VectorXd::Random(n);
    scalarField x(s.map.nUnknowns());
    forAll(x, u) x[u] = x0[s.map.global(u)];
    s.c.distribute(x);
    for (int threads = 1; threads <= 3; ++threads)
    {
        omp_set_num_threads(threads);
        feMatrix K(s.map, s.map, &s.c, s.scatter);
        s.colour(K);
        s.fill(K);
        labelList row, col;
        K.triplets(row, col);
        K.values(values[threads - 1]);
        products[threads - 1].setSize(x.size());
        K.multiply(x, products[threads - 1]);
        if (threads > 1) continue;

        scalarField all(n*n, 0);
        forAll(row, k) all[row[k]*n + col[k]] += values[0][k];
        Pstream::listCombineGather(all, plusEqOp<scalar>());
        Pstream::listCombineScatter(all);
        matrix B = Eigen::Map<const Eigen::Matrix<double, -1, -1, Eigen::RowMajor>>(all.cdata(), n, n);
        for (label g = 0; g < n; ++g)
        {
            if (s.reference.isFree(g)) continue;
            EXPECT_EQ(B(g, g), 1);
            B(g, g) = 0;
        }
        EXPECT_LT((B - C).norm(), 1e-13*C.norm());
    }
    omp_set_num_threads(nThreads);
    EXPECT_TRUE(values[0] == values[1] && values[0] == values[2]);
    EXPECT_TRUE(products[0] == products[1] && products[0] == products[2]);

    // On the rows of free unknowns
    const Eigen::VectorXd y = denseVector(s.map, products[0]), exact = C*x0;
    for (label g = 0; g < n; ++g)
    {
        if (s.reference.isFree(g)) { EXPECT_NEAR(y[g], exact[g], 1e-12*exact.norm()); }
    }
}


//- Values of given unknowns and the b_i count on the rows of free ones
TEST(matrixOnRanks, affineOnesKnowTheConstants)
{
    randomSystemOnRanks s;
    const label n = s.reference.size();
    feMatrix K(s.map, s.map, &s.c, s.scatter, true);
    s.colour(K);
    s.fill(K);

    const Eigen::VectorXd x0 = Eigen::VectorXd::Random(n);
    const Eigen::VectorXd state = s.reference.T*x0 + s.reference.b;
    const Eigen::VectorXd exact = s.reference.Tf.transpose()*(s.dense()*state);
    scalarField x(s.map.nUnknowns()), product(x);
    forAll(x, u) x[u] = s.reference.tied[s.map.global(u)] ? 0 : x0[s.map.global(u)];
    for (const label u : s.c.slaves()) x[u] = s.c.b(u);
    K.multiply(x, product);
    const Eigen::VectorXd y = denseVector(s.map, product);
    for (label g = 0; g < n; ++g)
    {
        if (s.reference.isFree(g)) { EXPECT_NEAR(y[g], exact[g], 1e-12*exact.norm()); }
    }

    // The free part is that of the matrix without
    feMatrix linear(s.map, s.map, &s.c, s.scatter);
    s.fill(linear);
    labelList row[2], col[2];
    scalarField values[2];
    K.triplets(row[0], col[0]);
    K.values(values[0]);
    linear.triplets(row[1], col[1]);
    linear.values(values[1]);
    EXPECT_TRUE(row[0] == row[1] && col[0] == col[1] && values[0] == values[1]);
}


//- Terms added by search, at any node of an element
TEST(matrixOnRanks, boundaryTermsGoToTheMasters)
{
    randomSystemOnRanks s;
    const label n = s.reference.size();
    feMatrix K(s.map, s.map, &s.c, s.scatter);
    const elementBlock& block = s.fe.blocks()[0];
    scalarField all(n*n, 0);
    for (label e = 0; e < block.size(); ++e)
    {
        const label row = s.unknowns.start(0, block.element(e)[e % block.nNodes]) + 1;
        const label col = s.unknowns.start(0, block.element(e)[(3*e + 1) % block.nNodes]);
        K.add(row, col, 1.5 + e);
        all[s.map.global(row)*n + s.map.global(col)] += 1.5 + e;
    }
    Pstream::listCombineGather(all, plusEqOp<scalar>());
    Pstream::listCombineScatter(all);
    const Eigen::Map<const Eigen::Matrix<double, -1, -1, Eigen::RowMajor>> A(all.cdata(), n, n);

    const Eigen::VectorXd x0 = Eigen::VectorXd::Random(n);
    const Eigen::VectorXd exact = s.reference.Tf.transpose()*(A*(s.reference.Tf*x0));
    scalarField x(s.map.nUnknowns()), product(x);
    forAll(x, u) x[u] = x0[s.map.global(u)];
    s.c.distribute(x);
    K.multiply(x, product);
    const Eigen::VectorXd y = denseVector(s.map, product);
    for (label g = 0; g < n; ++g)
    {
        if (s.reference.isFree(g)) { EXPECT_NEAR(y[g], exact[g], 1e-12*exact.norm()); }
    }
}


// ************************************************************************* //
