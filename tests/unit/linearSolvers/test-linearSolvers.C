/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    test-linearSolvers

Description
    Tests of the linear solvers, in serial and on any number of ranks:

        test-linearSolvers
        mpirun -np 3 test-linearSolvers -parallel

    Every check is of a value that is known on all ranks, so that all go on or
    fail together.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "flowSystem.H"
#include "feLinearSolver.H"
#include "PstreamReduceOps.H"
#include "IStringStream.H"
#include "Random.H"

#include <Eigen/SparseLU>
#include <gtest/gtest.h>
#include <limits>

using namespace Foam;
using outcome = feLinearSolver::outcome;

namespace
{

autoPtr<feLinearSolver> newSolver(const string& controls)
{
    IStringStream stream(controls);
    return feLinearSolver::New(dictionary(stream));
}


//- The message of the FatalIOError that a dictionary gives
std::string complaintAbout(const string& controls)
{
    const bool throwing = FatalIOError.throwExceptions();
    std::string message;
    try
    {
        newSolver(controls);
    }
    catch (const Foam::IOerror& error)
    {
        message = error.message();
    }
    FatalIOError.throwExceptions(throwing);
    return message;
}


scalar maxDifference(const scalarField& a, const scalarField& b)
{
    scalar result = 0;
    forAll(a, i)
    {
        // Not finite counts as large
        result = std::abs(a[i] - b[i]) < GREAT
          ? max(result, std::abs(a[i] - b[i])) : VGREAT;
    }
    return returnReduce(result, maxOp<scalar>());
}


flowSystem::parameters smallFlow()
{
    flowSystem::parameters p;
    p.nElements = 6;
    return p;
}


//- Solve for the manufactured solution and return the error
scalar solutionError(feLinearSolver& solver, const flowSystem& system)
{
    scalarField x(system.product(system.manufactured()));
    EXPECT_EQ(solver.solve(x), outcome::OK);
    return maxDifference(x, system.manufactured());
}


//- An unsymmetric matrix of random sparsity, each entry in pieces that are
//  dealt to the ranks, and its solution by Eigen
struct randomSystem
{
    feMatrixPattern pattern;
    scalarList values;
    scalarField b, x;

    explicit randomSystem(const label n)
    {
        pattern.unknowns = globalIndex((n*(Pstream::myProcNo() + 1))
           /Pstream::nProcs() - (n*Pstream::myProcNo())/Pstream::nProcs());

        Random random(11);
        Eigen::SparseMatrix<double> A(n, n);
        Eigen::VectorXd rhs(n);
        std::vector<Eigen::Triplet<double>> triplets;
        label nPieces = 0;

        for (label i = 0; i < n; ++i)
        {
            rhs[i] = random.sample01<scalar>();
            for (label k = 0; k < 12; ++k)
            {
                const label j = (k < 2 ? i : random.position<label>(0, n - 1));
                const scalar a = random.sample01<scalar>() + (k < 2 ? 2 : 0);
                triplets.emplace_back(i, j, a);
                if (nPieces++ % Pstream::nProcs() == Pstream::myProcNo())
                {
                    pattern.row.append(i);
                    pattern.col.append(j);
                    values.append(a);
                }
            }
        }

        A.setFromTriplets(triplets.begin(), triplets.end());
        Eigen::SparseLU<Eigen::SparseMatrix<double>> lu(A);
        const Eigen::VectorXd solution(lu.solve(rhs));

        const label first = pattern.unknowns.localStart();
        b.setSize(pattern.unknowns.localSize());
        x.setSize(b.size());
        forAll(b, i)
        {
            b[i] = rhs[first + i];
            x[i] = solution[first + i];
        }
    }
};

} // End namespace


// A solver shall agree with another program on a matrix without structure,
// whose entries come in pieces from several ranks
TEST(MUMPS, randomMatrixAsEigen)
{
    const randomSystem system(300);

    for (const char* ordering : {"METIS", "automatic"})
    {
        auto solver(newSolver(string("type MUMPS; ordering ") + ordering + ";"));
        solver->analyse(system.pattern);
        ASSERT_EQ(solver->factorise(system.values), outcome::OK);

        scalarField x(system.b);
        ASSERT_EQ(solver->solve(x), outcome::OK);
        EXPECT_LT(maxDifference(x, system.x), 1e-10) << ordering;
    }
}


// Right-hand sides given together shall be solved as each on its own, before
// and after a single one
TEST(MUMPS, severalRightHandSides)
{
    const randomSystem system(300);
    auto solver(newSolver("type MUMPS;"));
    solver->analyse(system.pattern);
    ASSERT_EQ(solver->factorise(system.values), outcome::OK);

    const label n = system.b.size();
    for (const label nRhs : {1, 3, 2, 1})
    {
        scalarField x(nRhs*n);
        for (label r = 0; r < nRhs; ++r) forAll(system.b, i) x[r*n + i] = (r + 1)*system.b[i];
        ASSERT_EQ(solver->solve(x, nRhs), outcome::OK);
        for (label r = 0; r < nRhs; ++r)
        {
            const scalarField column(SubList<scalar>(x, n, r*n));
            EXPECT_LT(maxDifference(column, (r + 1)*system.x), 1e-10) << r << " of " << nRhs;
        }
    }
}


// The pieces of an entry shall be summed, on a rank and over the ranks
TEST(MUMPS, duplicatesAreSummed)
{
    flowSystem::parameters p(smallFlow());

    for (const bool assembled : {true, false})
    {
        p.assembled = assembled;
        const flowSystem system(p);
        auto solver(newSolver("type MUMPS;"));
        solver->analyse(system.pattern);
        ASSERT_EQ(solver->factorise(system.values), outcome::OK);
        EXPECT_LT(solutionError(*solver, system), 1e-10);
    }
}


// One analysis shall serve many matrices, one factorisation many right-hand
// sides; the caller's values shall stay as they were
TEST(MUMPS, factorisesAgainWithoutAnalysis)
{
    flowSystem::parameters p(smallFlow());
    auto solver(newSolver("type MUMPS;"));
    solver->analyse(flowSystem(p).pattern);

    for (const scalar mu : {1.0, 1e-3, 50.0})
    {
        p.mu = mu;
        const flowSystem system(p);
        scalarList values(system.values);
        ASSERT_EQ(solver->factorise(values), outcome::OK);
        EXPECT_TRUE(values == system.values);

        // Not needed any more
        values = 0;
        EXPECT_LT(solutionError(*solver, system), 1e-9);
        EXPECT_LT(solutionError(*solver, system), 1e-9);
    }
    EXPECT_EQ(solver->stats().nFactorisations, 3);
    EXPECT_EQ(solver->stats().nSolutions, 6);
    EXPECT_GT(solver->stats().nNonzeros, 1000);
    EXPECT_GT(solver->stats().nFlops, 1000);
}


// A new mesh shall need no new solver
TEST(MUMPS, analysesAgain)
{
    flowSystem::parameters p(smallFlow());
    auto solver(newSolver("type MUMPS;"));

    for (const label nElements : {6, 9, 4})
    {
        p.nElements = nElements;
        const flowSystem system(p);
        solver->analyse(system.pattern);
        ASSERT_EQ(solver->factorise(system.values), outcome::OK);
        EXPECT_LT(solutionError(*solver, system), 1e-10);
    }
}


// A rank may own nothing, or have no triplets
TEST(MUMPS, oneRankHasAll)
{
    const label n = Pstream::master() ? 20 : 0;
    feMatrixPattern pattern;
    pattern.unknowns = globalIndex(n);
    pattern.row = identity(n);
    pattern.col = identity(n);
    auto solver(newSolver("type MUMPS;"));
    solver->analyse(pattern);
    ASSERT_EQ(solver->factorise(scalarList(n, 4.0)), outcome::OK);

    scalarField x(n, 2.0);
    ASSERT_EQ(solver->solve(x), outcome::OK);
    EXPECT_LT(maxDifference(x, scalarField(n, 0.5)), 1e-15);
}


// The pressure's level is undetermined in a closed box: round-off hides it from
// the factorisation, but a solver shall tell, and name a pressure
TEST(MUMPS, closedBoxIsSingular)
{
    flowSystem::parameters p(smallFlow());
    p.closed = true;

    for (const scalar mu : {1.0, 1e-6, 1e6})
    {
        p.mu = mu;
        const flowSystem system(p);
        auto solver(newSolver("type MUMPS;"));
        solver->analyse(system.pattern);
        ASSERT_EQ(solver->factorise(system.values), outcome::SINGULAR);

        // Three unknowns at a corner node, two elsewhere
        const label unknown = solver->singularUnknown();
        ASSERT_NE(unknown, -1);
        label isPressure = 0;
        forAll(system.pattern.nodeStart, node)
        {
            isPressure += system.pattern.nodeStart[node] + 2 == unknown
             && !system.pattern.nodeStart.found(unknown);
        }
        EXPECT_EQ(returnReduce(isPressure, sumOp<label>()), 1);
    }
}


// An unknown without an equation shall be named, and spoil nothing
TEST(MUMPS, emptyRowIsSingular)
{
    const flowSystem system(smallFlow());
    const label lost = system.pattern.unknowns.size()/2;
    scalarList values(system.values);
    forAll(values, k)
    {
        if (system.pattern.row[k] == lost || system.pattern.col[k] == lost)
        {
            values[k] = 0;
        }
    }

    auto solver(newSolver("type MUMPS;"));
    solver->analyse(system.pattern);
    EXPECT_EQ(solver->factorise(values), outcome::SINGULAR);
    EXPECT_EQ(solver->singularUnknown(), lost);

    EXPECT_EQ(solver->factorise(system.values), outcome::OK);
    EXPECT_EQ(solver->singularUnknown(), -1);
    EXPECT_LT(solutionError(*solver, system), 1e-10);
}


// A regular matrix in awkward units shall not be taken for a singular one
TEST(MUMPS, unitsDoNotMakeSingular)
{
    flowSystem system(smallFlow());
    forAll(system.values, k)
    {
        system.values[k] *=
            std::pow(10.0, 8*std::sin(1.0*system.pattern.row[k]))
           *std::pow(10.0, 8*std::cos(2.0*system.pattern.col[k]));
    }
    auto solver(newSolver("type MUMPS;"));
    solver->analyse(system.pattern);
    EXPECT_EQ(solver->factorise(system.values), outcome::OK);
}


// Values that are no numbers shall be told, on all ranks
TEST(MUMPS, notANumber)
{
    const flowSystem system(smallFlow());
    auto solver(newSolver("type MUMPS;"));
    solver->analyse(system.pattern);

    scalarList values(system.values);
    const scalar nan = std::numeric_limits<scalar>::quiet_NaN();
    label row = -1;
    if (Pstream::master())
    {
        values[values.size()/2] = nan;
        row = system.pattern.row[values.size()/2];
    }
    reduce(row, maxOp<label>());
    EXPECT_EQ(solver->factorise(values), outcome::SINGULAR);
    EXPECT_EQ(solver->singularUnknown(), row);

    ASSERT_EQ(solver->factorise(system.values), outcome::OK);
    scalarField x(system.pattern.unknowns.localSize(), 1.0);
    if (Pstream::master())
    {
        x[0] = nan;
    }
    EXPECT_EQ(solver->solve(x), outcome::SINGULAR);
    EXPECT_LT(solutionError(*solver, system), 1e-10);
}


// Too small a workspace shall be enlarged, and remembered
TEST(MUMPS, workspaceGrows)
{
    flowSystem::parameters p(smallFlow());
    p.nElements = 30;
    const flowSystem system(p);
    auto solver(newSolver("type MUMPS; memoryRelaxation -60;"));
    solver->analyse(system.pattern);

    for (const bool first : {true, false})
    {
        std::ostringstream log;
        auto* buffer = std::cout.rdbuf(log.rdbuf());
        const outcome result = solver->factorise(system.values);
        std::cout.rdbuf(buffer);

        ASSERT_EQ(result, outcome::OK);
        EXPECT_LT(solutionError(*solver, system), 1e-9);
        if (Pstream::master())
        {
            EXPECT_EQ
            (
                log.str().find("workspace too small") != std::string::npos,
                first
            ) << log.str();
        }
    }
}


// The user's limit of memory shall be kept
TEST(MUMPS, outOfMemory)
{
    flowSystem::parameters p(smallFlow());
    p.nElements = 40;
    const flowSystem system(p);
    auto solver(newSolver("type MUMPS; maxMemory 2;"));
    solver->analyse(system.pattern);
    EXPECT_EQ(solver->factorise(system.values), outcome::OUT_OF_MEMORY);
}


// Compression shall keep its accuracy
TEST(MUMPS, blockLowRank)
{
    flowSystem::parameters p(smallFlow());
    p.nElements = 30;
    const flowSystem system(p);
    auto solver(newSolver("type MUMPS; blockLowRank 1e-10;"));
    solver->analyse(system.pattern);
    ASSERT_EQ(solver->factorise(system.values), outcome::OK);
    EXPECT_LT(solutionError(*solver, system), 1e-4);
}


// A wrong keyword shall be answered by the choices
TEST(dictionary, namesTheChoices)
{
    const auto has = [](const std::string& message, const char* text)
    {
        return message.find(text) != std::string::npos;
    };

    EXPECT_TRUE(has(complaintAbout("type Gauss;"), "Gauss"));
    EXPECT_TRUE(has(complaintAbout("type Gauss;"), "MUMPS"));
    EXPECT_TRUE(has(complaintAbout("ordering METIS;"), "type"));

    const auto ordering = complaintAbout("type MUMPS; ordering best;");
    EXPECT_TRUE(has(ordering, "METIS")) << ordering;
    EXPECT_TRUE(has(ordering, "automatic")) << ordering;

    EXPECT_TRUE(has(complaintAbout("type MUMPS; scaling 3;"), "0 7 8 77"));
    EXPECT_TRUE(has(complaintAbout("type MUMPS; threads 0;"), "1 to"));
    EXPECT_TRUE(has(complaintAbout("type MUMPS; pivotThreshold 2;"), "0 to 1"));
    EXPECT_TRUE(has(complaintAbout("type MUMPS; ICNTL ((18 0));"), "ICNTL(18)"));
    EXPECT_EQ(complaintAbout("type MUMPS; ICNTL ((13 0)); scaling 0;"), "");
}


int main(int argc, char *argv[])
{
    ::testing::InitGoogleTest(&argc, argv);

    argList::noBanner();
    argList::noCheckProcessorDirectories();
    argList args(argc, argv, false, true, false);

    auto& listeners = ::testing::UnitTest::GetInstance()->listeners();
    if (!Pstream::master())
    {
        delete listeners.Release(listeners.default_result_printer());
    }

    const label failed = RUN_ALL_TESTS();
    const label nFailed = returnReduce(failed, sumOp<label>());
    Info<< nFailed << " ranks with failures" << endl;

    // The destructor of argList would exit with status 0
    Pstream::exit(nFailed ? 1 : 0);
    return 0;
}


// ************************************************************************* //
