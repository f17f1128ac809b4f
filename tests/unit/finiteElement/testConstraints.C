/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Tests of dofConstraints, on one rank and on several, against dense matrices.
\*---------------------------------------------------------------------------*/

#include "dofConstraints.H"
#include "denseConstraints.H"
#include "Random.H"
#include <Eigen/Dense>
#include <gtest/gtest.h>

using namespace Foam;

namespace
{

typedef dofConstraints::term term;
typedef Eigen::MatrixXd matrix;

//- One unknown at each of some nodes of one rank
struct unknownsOf
{
    nodeMap map;
    dofConstraints c;

    explicit unknownsOf(const label n) : map(identity(n), labelList(n, 1)), c(map) {}
};

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

//- The message of the error of close()
std::string complaint(dofConstraints& c)
{
    const bool throwing = FatalError.throwExceptions();
    std::string message;
    try { c.close(); }
    catch (const Foam::error& error) { message = error.message(); }
    FatalError.throwExceptions(throwing);
    return message;
}


//- Eight nodes a rank, of which the next one has three, too, and one of all,
//  key ALL; three unknowns at each, at that of all four
struct chainOfRanks
{
    static constexpr label ALL = 10000;
    const label me = Pstream::myProcNo(), n = Pstream::nProcs();
    nodeMap map;
    const label nOwn;
    dofConstraints c;

    //- First global unknown of each key
    Map<label> first;

    chainOfRanks()
    :
        map(keys(), counts()),
        nOwn(map.nUnknowns()),
        c(map)
    {
        labelList key, start;
        for (const label node : map.ownedNodes())
        {
            key.append(map.key(node));
            start.append(map.global(map.start(node)));
        }
        key = gatherAll<label>(key);
        start = gatherAll<label>(start);
        forAll(key, i) first.insert(key[i], start[i]);
    }

    static labelList keys()
    {
        labelList key(identity(8));
        for (label& k : key) k += 5*Pstream::myProcNo();
        key.append(ALL);
        return key;
    }

    //- One rank knows more of the common node than the others
    static labelList counts()
    {
        labelList n(9, 3);
        n.last() = Pstream::myProcNo() == Pstream::nProcs() - 1 ? 4 : 1;
        return n;
    }

    //- Global number of an unknown of any rank; local number of one that is here
    label global(const label key, const label cmpt) const { return first[key] + cmpt; }
    label here(const label key, const label cmpt) const { return map.local(global(key, cmpt)); }

    //- Key of node i of the next rank, after the last the first
    label next(const label i) const { return 5*((me + 1) % n) + i; }

    //- Masters at nodes of other ranks, chains over the ranks, given masters,
    //  rows that one rank of several knows; weights times a factor
    void declare(const scalar factor, dofConstraints& to)
    {
        const label own = 5*me;
        const auto w = [&](const scalar weight) { return factor*weight; };
        to.tieGlobal
        (
            here(own + 3, 0),
            List<term>({{global(next(4), 1), w(0.7)}, {global(ALL, 0), w(-1.2)}}),
            0.3 + me
        );

        // A chain from rank to rank, and on to what is tied above
        const label target = me < n - 1 ? global(next(4), 0) : global(3, 0);
        to.tieGlobal(here(own + 4, 0), List<term>(1, term{target, w(2)}), 1 + me);

        to.fix(here(own + 3, 2));
        to.tieGlobal
        (
            here(own + 4, 2),
            List<term>({{global(next(3), 2), w(0.5)}, {global(ALL, 3), w(1.5)}}),
            -2
        );

        // All its masters are given
        if (me == n - 1) to.tieGlobal(here(ALL, 2), List<term>(1, term{global(3, 2), w(2)}), 0.1);

        // Shared with the next rank: known here only, there only, on both
        if (me < n - 1)
        {
            to.tieGlobal
            (
                here(own + 6, 0),
                List<term>({{global(own + 2, 1), w(1)}, {global(own + 3, 0), w(-3)}})
            );
            to.tie(here(own + 7, 0), List<term>(1, term{here(ALL, 0), w(3)}), 0.5);
        }
        if (me > 0)
        {
            to.fix(here(own + 1, 1));
            to.tie(here(own + 2, 0), List<term>(1, term{here(ALL, 0), w(3)}), 0.5);
        }
    }
};


//- The rows that chainOfRanks declares with a factor, dense and closed
denseConstraints dense(chainOfRanks& r, const scalar factor)
{
    denseConstraints d(r.map.numbering().size());
    for (label rank = 0; rank < r.n; ++rank)
    {
        const auto g = [&](const label key, const label cmpt) { return r.global(key, cmpt); };
        const label own = 5*rank, next = 5*((rank + 1) % r.n), all = r.ALL;
        d.tie(g(own + 3, 0), {{g(next + 4, 1), factor*0.7}, {g(all, 0), factor*(-1.2)}}, 0.3 + rank);
        d.tie(g(own + 4, 0), {{rank < r.n - 1 ? g(next + 4, 0) : g(3, 0), factor*2}}, 1 + rank);
        d.fix(g(own + 3, 2));
        d.tie(g(own + 4, 2), {{g(next + 3, 2), factor*0.5}, {g(all, 3), factor*1.5}}, -2);
        if (rank == r.n - 1) d.tie(g(all, 2), {{g(3, 2), factor*2}}, 0.1);
        if (rank < r.n - 1)
        {
            d.tie(g(own + 6, 0), {{g(own + 2, 1), factor}, {g(own + 3, 0), factor*(-3)}}, 0);
            d.tie(g(own + 7, 0), {{g(all, 0), factor*3}}, 0.5);
        }
        if (rank > 0) d.fix(g(own + 1, 1));
    }
    d.close();
    return d;
}


//- Kinds, masters, weights and b_i of a rank against dense ones. Ghosts have
//  no rows, but are known to be free or not
void expectRows(const chainOfRanks& r, const denseConstraints& d)
{
    label nTied = 0;
    for (label u = 0; u < r.map.nUnknowns(); ++u)
    {
        const label g = r.map.global(u);
        SCOPED_TRACE("unknown " + std::to_string(g));
        EXPECT_EQ(r.c.isFree(u), d.isFree(g));
        EXPECT_EQ(r.c.isGiven(u), d.given[g]);
        if (u >= r.nOwn) continue;

        EXPECT_EQ(r.c.isTied(u), d.tied[g]);
        EXPECT_EQ(r.c.isFixed(u), !d.isFree(g) && d.Tf.row(g).norm() < 1e-12);
        if (!r.c.isTied(u) || !d.tied[g]) continue;
        ++nTied;
        Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(d.size());
        for (const term& t : r.c.masters(u))
        {
            EXPECT_FALSE(r.c.isTied(t.unknown));
            EXPECT_EQ(row[r.map.global(t.unknown)], 0) << "a master twice";
            row[r.map.global(t.unknown)] = t.weight;
        }
        EXPECT_LT((row - d.T.row(g)).norm(), 1e-14*(1 + row.norm()));
        EXPECT_NEAR(r.c.b(u), d.b[g], 1e-14*(1 + mag(d.b[g])));
    }
    EXPECT_GE(nTied, 3);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(dofConstraints, closesChains)
{
    unknownsOf u(7);
    dofConstraints& c = u.c;
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

    // It remains a master of the state
    EXPECT_EQ(c.masters(0).size(), 3);
    scalarField x(7, 0);
    x[3] = 1;
    c.impose(x);
    EXPECT_EQ(x[0], 6);

    // All of its masters are fixed: so is it
    EXPECT_TRUE(c.isFixed(6));
    EXPECT_TRUE(c.isFree(2));
}


TEST(dofConstraints, theLastWordCounts)
{
    unknownsOf u(3);
    dofConstraints& c = u.c;
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
    unknownsOf two(2), four(4), another(4);
    dofConstraints &self = two.c, &three = four.c, &tail = another.c;
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
    unknownsOf u(20);
    dofConstraints& c = u.c;
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


TEST(constraintsOnRanks, rowsAreThoseOfADenseClosure)
{
    chainOfRanks r;
    r.declare(1, r.c);
    r.c.close();
    expectRows(r, dense(r, 1));

    // What was here has kept its numbers; ghosts are of others
    const labelList key(r.keys());
    forAll(key, i) EXPECT_EQ(r.map.key(i), key[i]);
    for (label i = key.size(); i < r.map.nNodes(); ++i) EXPECT_FALSE(r.map.owned(i));
    EXPECT_EQ(r.map.nNodes() > key.size(), r.n > 1);
}


TEST(constraintsOnRanks, statesAndResidualsAreTransformed)
{
    chainOfRanks r;
    r.declare(1, r.c);
    r.c.close();
    const denseConstraints d(dense(r, 1));
    const nodeMap& map = r.map;

    const Eigen::VectorXd x0 = Eigen::VectorXd::Random(d.size());
    scalarField state(map.nUnknowns()), homogeneous(state), increment(state);
    forAll(state, u) state[u] = homogeneous[u] = increment[u] = x0[map.global(u)];
    r.c.impose(state);
    r.c.imposeHomogeneous(homogeneous);
    r.c.distribute(increment);
    const Eigen::VectorXd linear = d.T*x0, affine = linear + d.b, free = d.Tf*x0;
    for (label u = 0; u < r.nOwn; ++u)
    {
        const label g = map.global(u);
        EXPECT_NEAR(state[u], affine[g], 1e-14*(1 + mag(affine[g])));
        EXPECT_NEAR(homogeneous[u], linear[g], 1e-14*(1 + mag(linear[g])));
        EXPECT_NEAR(increment[u], free[g], 1e-14*(1 + mag(free[g])));
    }

    // A residual of several parts, also where the unknown is another rank's
    scalarField R(map.nUnknowns(), 0);
    Foam::Random random(3 + r.me);
    for (label u = 0; u < r.nOwn; ++u) R[u] = random.GaussNormal<scalar>();
    const Eigen::VectorXd all = denseVector(map, R);
    const scalar work = returnReduce(sumProd(increment, R), sumOp<scalar>());
    r.c.condense(R);
    scalarField start(map.nUnknowns());
    forAll(start, u) start[u] = x0[map.global(u)];
    EXPECT_NEAR(returnReduce(sumProd(start, R), sumOp<scalar>()), work, 1e-12);
    map.sum(R);
    const Eigen::VectorXd condensed = d.Tf.transpose()*all;
    for (label u = 0; u < r.nOwn; ++u) EXPECT_NEAR(R[u], condensed[map.global(u)], 1e-13);
}


//- Other weights leave the structure as it is, other masters do not
TEST(constraintsOnRanks, areDeclaredAnew)
{
    chainOfRanks r;
    r.declare(1, r.c);
    EXPECT_FALSE(r.c.close());
    const label nUnknowns = r.map.nUnknowns();
    for (const scalar factor : {1.0, 1.7})
    {
        SCOPED_TRACE(factor);
        r.c.reopen();
        r.declare(factor, r.c);
        EXPECT_TRUE(r.c.close());
        EXPECT_EQ(r.map.nUnknowns(), nUnknowns);
        expectRows(r, dense(r, factor));
    }

    // On one rank
    r.c.reopen();
    r.declare(1, r.c);
    if (r.me == 0) r.c.tieGlobal(r.here(3, 0), List<term>(1, term{r.global(r.next(3), 1), 1}));
    EXPECT_FALSE(r.c.close());

    r.c.reopen();
    r.declare(1, r.c);
    r.c.close();
    expectRows(r, dense(r, 1));

    // An unknown less
    r.c.reopen();
    EXPECT_FALSE(r.c.close());
    for (label u = 0; u < r.map.nUnknowns(); ++u) EXPECT_TRUE(r.c.isFree(u));
}


//- Rank 0 ties the first unknown of its node to the second, as a slip plane
//  does; the other ranks tie to the second, so that the node is their ghost
TEST(constraintsOnRanks, ghostsThatAreTiedChangeNothing)
{
    const label me = Pstream::myProcNo();
    nodeMap map(labelList(1, me), labelList(1, 2));
    dofConstraints c(map);
    const label master = returnReduce(me == 0 ? map.global(1) : 0, sumOp<label>());
    const auto declare = [&]()
    {
        if (me == 0) c.tie(0, List<term>(1, term{1, -0.5}));
        else c.tieGlobal(0, List<term>(1, term{master, 2}));
    };
    declare();
    c.close();
    const label nUnknowns = map.nUnknowns();
    const labelList slaves(c.slaves());
    c.reopen();
    declare();
    EXPECT_TRUE(c.close());
    EXPECT_EQ(map.nUnknowns(), nUnknowns);
    EXPECT_EQ(c.slaves(), slaves);
}


TEST(constraintsOnRanks, aCycleIsAnError)
{
    chainOfRanks r;
    r.c.tieGlobal(r.here(5*r.me + 3, 0), List<term>(1, term{r.global(r.next(3), 0), 0.5}));
    const std::string message = complaint(r.c);
    EXPECT_NE(message.find("refers to itself"), std::string::npos) << message;
}


//- The last two ranks, at the node that all have
TEST(constraintsOnRanks, differentRowsAreAnError)
{
    for (const label way : {0, 1, 2})
    {
        chainOfRanks r;
        const label u = r.here(r.ALL, 0);
        const auto tie = [&](const label cmpt, const scalar b)
        {
            r.c.tieGlobal(u, List<term>(1, term{r.global(r.ALL, cmpt), 0.5}), b);
        };
        if (r.me == r.n - 2) tie(1, 0);
        if (r.me == r.n - 1)
        {
            if (way == 0) tie(3, 0);
            if (way == 1) tie(1, 0.1);
            if (way == 2) r.c.fix(u);
        }
        const std::string message = complaint(r.c);
        EXPECT_EQ(message.find("have different constraints") != std::string::npos, r.n > 1) << message;
    }
}


// ************************************************************************* //
