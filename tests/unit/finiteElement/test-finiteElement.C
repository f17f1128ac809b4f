/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    test-finiteElement

Description
    Tests of src/finiteElement. On several ranks, those that are about ranks:

        test-finiteElement
        mpirun -np 3 test-finiteElement -parallel
\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "PstreamReduceOps.H"
#include <gtest/gtest.h>

using namespace Foam;

int main(int argc, char *argv[])
{
    ::testing::InitGoogleTest(&argc, argv);

    argList::noBanner();
    argList::noCheckProcessorDirectories();
    argList args(argc, argv, false, true, false);

    if (Pstream::parRun()) ::testing::GTEST_FLAG(filter) = "nodeMap.*:decomposed.*";
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
