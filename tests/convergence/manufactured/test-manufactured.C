/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    test-manufactured

Description
    monolithicFoam with the force density of a manufacturedSolution. Prints the
    errors at the last time relative to the solution, for the scripts run of
    tests/convergence. system/controlDict has

        solution    smooth;     // or polynomial, wall
\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "Time.H"
#include "coupledSystem.H"
#include "aleFluid.H"
#include "nonlinearSolid.H"
#include "manufacturedSolution.H"
#include "errorNorm.H"

using namespace Foam;

//- Set the source of a region
void setSource(feRegion& region)
{
    manufacturedSolution& s = manufacturedSolution::theSolution();
    IOdictionary dict
    (
        IOobject
        (
            isA<aleFluid>(region) ? "transportProperties" : "mechanicalProperties",
            region.mesh().time().constant(), region.mesh(),
            IOobject::MUST_READ, IOobject::NO_WRITE, false
        )
    );

    if (isA<aleFluid>(region))
    {
        const scalar rho = dimensionedScalar("rho", dimDensity, dict).value();
        const scalar mu = dimensionedScalar("mu", dimDynamicViscosity, dict).value();
        s.mu = mu;
        refCast<aleFluid>(region).source =
            [=, &s](const point& x, const scalar t) { return s.flowForce(x, t, rho, mu); };
    }
    else
    {
        const PtrList<entry> materials(dict.lookup("materials"));
        const dictionary material(materials[0].dict());
        s.material = material;
        refCast<nonlinearSolid>(region).source =
            [=, &s](const point& x, const scalar t) { return s.solidForce(x, t, material); };
    }
}


void reportErrors(const feRegion& region, const scalar t)
{
    const manufacturedSolution& s = manufacturedSolution::theSolution();
    const feMesh& fe = region.fe();
    if (isA<aleFluid>(region))
    {
        const aleFluid& fluid = refCast<const aleFluid>(region);

        // Taylor-Hood's pressure is that of the vertices; of the cells' the mean
        const word smoothed("pointPSmoothed");
        scalarField p
        (
            region.mesh().foundObject<pointScalarField>(smoothed)
          ? scalarField(region.mesh().lookupObject<pointScalarField>(smoothed).primitiveField(), fe.vertexPoint())
          : scalarField(fluid.endPressure())
        );
        p.setSize(fe.nNodes());
        const List<labelList>& parent = fe.parents();
        forAll(parent, n)
        {
            if (parent[n].empty()) continue;
            p[n] = 0;
            for (const label m : parent[n]) p[n] += p[m]/parent[n].size();
        }
        const vectorField x(fe.points() + region.motion().D);
        Info<< "errors U "
            << errorNorm(fe, x, fluid.velocity().v, [&](const point& x) { return s.U(x, t); })
            << " p " << errorNorm(fe, x, p, [&](const point& x) { return s.p(x, t); }) << endl;
    }
    else
    {
        const motionField& motion = region.motion();
        Info<< "errors D " << errorNorm(fe, fe.points(), motion.D, [&](const point& x) { return s.D(x, t); });
        if (!region.timeScheme().steady())
        {
            Info<< " V " << errorNorm(fe, fe.points(), motion.v, [&](const point& x) { return s.V(x, t); });
        }
        Info<< endl;
    }
}


int main(int argc, char *argv[])
{
    #include "setRootCase.H"
    #include "createTime.H"

    const dictionary& control = runTime.controlDict();
    manufacturedSolution::theSolution = manufacturedSolution::New
    (
        control.get<word>("solution"), control.get<label>("dimensions")
    );

    coupledSystem problem(runTime);
    for (feRegion& region : problem.regions()) setSource(region);

    while (runTime.loop())
    {
        problem.store();
        if (!problem.step())
        {
            FatalErrorInFunction
                << "No convergence at time " << runTime.timeName() << exit(FatalError);
        }
        problem.advance();
    }
    for (feRegion& region : problem.regions()) region.derive();
    for (const feRegion& region : problem.regions()) reportErrors(region, runTime.value());
    return 0;
}


// ************************************************************************* //
