/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Tests of nonlinearSolid with mixed elements: locking, tangents, materials
    beside one another, errors of the dictionaries.
\*---------------------------------------------------------------------------*/

#include "solidCase.H"
#include "Random.H"

using namespace Foam;

namespace
{

const char* const rubber = "type isochoricNeoHookean; rho 1; mu 80.1938;";

//- Two bricks on one another, the upper one loaded
void bricks(solidCase& c, const std::string& elements, const std::string& below, const std::string& above)
{
    c.elements = elements;
    c.blockMesh =
        "vertices ((0 0 0) (1 0.1 0) (1 1 0) (0 1 0.1) (0 0 1) (1 0 1) (1.2 1 1) (0 1 1)"
        " (0 0 2) (1 0 2) (1 1 2) (0 1 2));"
        "blocks (hex (0 1 2 3 4 5 6 7) below (2 2 2) simpleGrading (1 1 1)"
        " hex (4 5 6 7 8 9 10 11) above (2 2 1) simpleGrading (1 1 1)); boundary ("
        "clamp { type wall; faces ((0 3 2 1)); } loaded { type patch; faces ((8 9 10 11)); });"
        "defaultPatch { name free; type patch; }";
    c.materials = "a {" + below + " cellZone below; } b {" + above + " cellZone above; }";
    c.pointD =
        "clamp { type fixedValue; value uniform (0 0 0); } free { type calculated; value uniform (0 0 0); }"
        "loaded { type followerPressure; pressure constant 0.1; value uniform (0 0 0); }";
}

//- Root mean square of p - (mean of the neighbours) beside that of p, for cells
//  that have neighbours all round: what is left of a checkerboard
scalar oscillation(const fvMesh& mesh, const scalarField& p)
{
    scalar sum = 0, all = 0;
    forAll(p, c)
    {
        const labelList& next = mesh.cellCells()[c];
        if (next.size() < 4) continue;
        scalar mean = 0;
        for (const label n : next) mean += p[n]/next.size();
        sum += sqr(p[c] - mean);
        all += sqr(p[c]);
    }
    return ::sqrt(sum/all);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

//- Incompressible: 6.931 converged, Q2Q1 of another code 6.9077, 6.9262, 6.9300
//  for 4, 8, 16 cells along a side
TEST(mixedSolid, CooksMembraneIncompressible)
{
    struct { const char* elements; const char* n; scalar tip, tolerance; } runs[] =
    {
        {"taylorHood", "4", 6.9077, 1e-3}, {"taylorHood", "8", 6.9262, 1e-3},
        {"Q1Q0", "16", 6.931, 0.12}, {"equalOrder", "16", 6.931, 0.12}
    };
    for (const auto& run : runs)
    {
        SCOPED_TRACE(run.elements);
        solidCase c;
        cook(c, run.n, run.elements, rubber, "table ((0 (0 0 0)) (0.5 (0 6.25 0)))");
        for (label step = 0; step < 5; ++step)
        {
            c.next();
            const label nIter = c.solve();
            EXPECT_GT(nIter, 0);
            EXPECT_LE(nIter, 9);
        }
        const scalar tip = c.displacement({48, 60, 0}).y();
        EXPECT_NEAR(tip, run.tip, run.tolerance);
        c.solid->derive();
        const fvMesh& mesh = c.solid->mesh();
        const scalarField& p = mesh.lookupObject<volScalarField>("solidPressure");
        const scalarField& unknown = *c.solid->state().find<scalar>("solidPressure");
        Info<< "    " << run.elements << ", " << run.n << " cells: tip " << tip
            << ", oscillation of p " << oscillation(mesh, p);
        if (unknown.size() == p.size()) Info<< ", of the unknown " << oscillation(mesh, unknown);
        Info<< endl;
        EXPECT_LT(oscillation(mesh, p), 0.1);
    }
}


//- A large bulk modulus is near incompressibility, where plain elements lock
TEST(mixedSolid, doesNotLock)
{
    const std::string stiff = std::string(rubber) + "bulkModulus 400942;";
    const auto tip = [&](const char* elements)
    {
        solidCase c;
        cook(c, "8", elements, stiff, "constant (0 0.1 0)");
        c.next();
        EXPECT_GT(c.solve(), 0);
        return c.displacement({48, 60, 0}).y();
    };
    const scalar fine = tip("taylorHood");
    EXPECT_NEAR(tip("Q1Q0"), fine, 0.08*fine);
    EXPECT_NEAR(tip("equalOrder"), fine, 0.08*fine);
    EXPECT_LT(tip("linear"), 0.6*fine);
}


TEST(mixedSolid, tangentHasTheTimeScheme)
{
    const char* const soft = "type MooneyRivlin; rho 2; c1 0.6; c2 0.1; c3 0.05;";
    const char* const steel = "type StVenantKirchhoff; rho 5; E 20; nu 0.3;";
    for (const char* scheme : {"type generalisedAlpha; rhoInf 0.5;", "type steady;"})
    {
        for (const char* elements : {"Q1Q0", "equalOrder", "taylorHood"})
        {
            SCOPED_TRACE(elements);
            solidCase c;
            bricks(c, elements, soft, steel);
            c.timeScheme = scheme;
            c.make();
            c.next();

            Foam::Random random(1);
            scalarField x(c.nUnknowns()), dx(x);
            const scalar size = std::string(scheme).find("steady") == std::string::npos ? 0.3 : 0.03;
            for (scalar& s : x) s = size*random.GaussNormal<scalar>();
            for (scalar& s : dx) s = random.GaussNormal<scalar>();
            c.update(x);

            // Of forces and of volumes
            const boolList isP(c.isPressure());
            for (const bool pressure : {false, true})
            {
                EXPECT_LT(c.tangentError(dx, [&](const label u) { return isP[u] == pressure; }), 1e-6);
            }
        }
    }
}


//- Volume is kept exactly where there is no bulk modulus, by each cell of Q1Q0
TEST(mixedSolid, keepsTheVolume)
{
    const char* const soft = "type Yeoh; rho 1; c10 0.5; c20 0.01; c30 0.01;";
    solidCase c;
    bricks(c, "Q1Q0", soft, soft);
    c.make();
    c.next();
    EXPECT_GT(c.solve(), 0);
    scalarField R(c.residual());
    const boolList isP(c.isPressure());
    forAll(R, u) EXPECT_LT(isP[u]*mag(R[u]), 1e-13);
    EXPECT_GT(gMax(mag(c.solid->motion().D)()), 0.05);
}


//- A metal in a region of mixed elements has no pressure: what it has no part
//  in is held at zero, and the stress is that of its law
TEST(mixedSolid, hasMaterialsWithoutPressure)
{
    const char* const steel = "type StVenantKirchhoff; rho 5; E 20; nu 0.3;";
    const char* const soft = "type isochoricNeoHookean; rho 1; mu 2;";
    for (const char* elements : {"Q1Q0", "equalOrder", "taylorHood"})
    {
        SCOPED_TRACE(elements);
        solidCase c;
        bricks(c, elements, soft, steel);
        c.make();
        c.next();
        EXPECT_GT(c.solve(), 0);
        c.solid->derive();
        const fvMesh& mesh = c.solid->mesh();
        const auto& p = mesh.lookupObject<volScalarField>("solidPressure");
        const auto& sigma = mesh.lookupObject<volSymmTensorField>("sigma");
        forAll(p, celli)
        {
            const bool metal = mesh.cellZones()["above"].whichCell(celli) >= 0;
            if (metal)
            {
                EXPECT_GT(mag(tr(sigma[celli])), 1e-3);
            }
            else
            {
                EXPECT_NEAR(tr(sigma[celli]), -3*p[celli], 1e-12);
            }
        }

        solidCase all;
        bricks(all, elements, steel, steel);
        all.make();
        all.next();
        EXPECT_GT(all.solve(), 0);
        all.solid->derive();
        EXPECT_EQ(gMax(mag(all.solid->mesh().lookupObject<volScalarField>("solidPressure").primitiveField())()), 0);
    }
}


TEST(mixedSolid, complainsAboutWhatItCannotBe)
{
    for (const char* elements : {"linear", "enhancedStrain", "quadratic"})
    {
        solidCase c;
        cook(c, "2", "linear", "type neoHookean; rho 1; E 1; nu 0;");
        solidCase bad;
        bad.blockMesh = c.blockMesh;
        bad.pointD = c.pointD;
        bad.elements = elements;
        bad.materials = "rubber { type isochoricNeoHookean; rho 1; mu 1; }";
        expectComplaint(bad, "has no bulkModulus, so it is incompressible");
    }

    // A prism has no Q1Q0
    solidCase c;
    c.elements = "Q1Q0";
    c.blockMesh =
        "vertices ((0 0 0) (1 0 0) (0 1 0) (0 0 1) (1 0 1) (0 1 1));"
        "blocks (hex (0 1 2 2 3 4 5 5) (1 1 1) simpleGrading (1 1 1)); boundary ();"
        "defaultPatch { name free; type patch; }";
    c.materials = "a { type isochoricNeoHookean; rho 1; mu 1; }";
    c.pointD = "free { type calculated; value uniform (0 0 0); }";
    expectComplaint(c, "is a prism; elements Q1Q0 are");
}


// ************************************************************************* //
