/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    monolithicFoam

Description
    Fluid-structure interaction by one system of finite elements: ALE flow,
    total-Lagrangian solids, moving meshes. Takes its physics from the case:
    a fluid or a solid alone runs, too.
\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "Time.H"
#include "coupledSystem.H"
#include "coupledInterfaceReport.H"
#include "exitOnIOError.H"
#include "stockFunctionObjects.H"

using namespace Foam;

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Fluid-structure interaction by one system of finite elements: regions"
        " and their solvers from regionSolvers in system/controlDict, interfaces"
        " from constant/couplingProperties"
    );
    argList::addBoolOption
    (
        "dry-run",
        "Read and check the case, report its size, and stop"
    );
    #include "setRootCase.H"
    exitOnIOError();
    #include "createTime.H"
    checkFunctionObjects(runTime);

    coupledSystem problem(runTime);
    const coupledInterfaceReport interfaces(runTime, problem);
    problem.report();
    if (args.found("dry-run"))
    {
        Info<< "Dry run: the case can be run" << nl << "End\n" << endl;
        return 0;
    }

    while (runTime.run())
    {
        problem.store();
        ++runTime;
        Info<< "Time = " << runTime.timeName() << nl;

        if (!problem.step())
        {
            // Back to the last good state, written if it is not the initial one
            const string reason(problem.reasonOfFailure());
            problem.restore();
            const bool written = runTime.timeIndex() > runTime.startTimeIndex();
            if (written)
            {
                problem.advance();
                runTime.writeNow();
                problem.writeState();
            }
            FatalErrorInFunction
                << "The step from time " << runTime.timeName() << " with deltaT "
                << runTime.deltaTValue() << " did not converge: "
                << newtonControl::outcomeName(problem.newton().outcome()) << " after "
                << problem.newton().nIterations() << " iterations." << nl
                << reason.c_str()
                << (written ? "The last good state has been written. " : "")
                << problem.newton().advice() << exit(FatalError);
        }

        problem.advance();
        runTime.write();
        if (runTime.writeTime()) problem.writeState();

        problem.reportTimes();
        runTime.printExecutionTime(Info);
    }

    problem.summary();
    Info<< "End\n" << endl;
    return 0;
}


// ************************************************************************* //
