/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Tests of the region solver nonlinearSolid on small meshes of blockMesh:
    Cook's membrane, loads and their tangents, errors of the dictionaries.
\*---------------------------------------------------------------------------*/

#include "solidCase.H"
#include "elementPatch.H"
#include "Random.H"

using namespace Foam;

namespace
{

void cube(solidCase& c)
{
    c.blockMesh =
        "vertices ((0 0 0) (1 0.1 0) (1 1 0) (0 1 0.1) (0 0 1) (1 0 1) (1.2 1 1) (0 1 1));"
        "blocks (hex (0 1 2 3 4 5 6 7) one (2 2 2) simpleGrading (1 1 1)); boundary ("
        "clamp { type wall; faces ((0 4 7 3)); } loaded { type patch; faces ((1 2 6 5) (4 5 6 7)); });"
        "defaultPatch { name free; type patch; }";
    c.materials = "rubber { type neoHookean; rho 1000; E 100; nu 0.3; }";
    c.pointD =
        "clamp { type fixedValue; value uniform (0 0 0); } free { type calculated; value uniform (0 0 0); }"
        "loaded { type followerPressure; pressure constant 20; value uniform (0 0 0); }";
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

//- Deflection of the tip: 6.1279 and 6.1389 with 16x16 and 32x32 biquadratic
//  elements of another code, 6.147 converged
TEST(nonlinearSolid, CooksMembrane)
{
    struct { const char* elements; const char* n; scalar tip, tolerance; } runs[] =
    {
        {"linear", "16", 6.147, 0.2}, {"enhancedStrain", "32", 6.147, 0.03},
        {"quadratic", "16", 6.1279, 1e-4}, {"quadratic", "32", 6.1389, 1e-4}
    };
    for (const auto& run : runs)
    {
        SCOPED_TRACE(run.elements);
        solidCase c;
        cook(c, run.n, run.elements);
        c.next();
        const label nIter = c.solve();
        EXPECT_GT(nIter, 0);
        EXPECT_LE(nIter, 7);
        EXPECT_NEAR(c.displacement({48, 60, 0}).y(), run.tip, run.tolerance);
    }
}


//- Forces on the clamp are those of the traction
TEST(nonlinearSolid, isInEquilibriumWithItsTraction)
{
    solidCase c;
    cook(c, "4", "enhancedStrain");
    c.next();
    c.solve();
    c.residual();
    vector clamp = Zero;
    const label patchi = c.solid->mesh().boundaryMesh().findPatchID("clamp");
    for (const label n : c.solid->fe().patchNodes(patchi)) clamp += c.solid->force()[n];
    EXPECT_NEAR(clamp.x(), 0, 1e-9);
    EXPECT_NEAR(clamp.y(), -64, 1e-9);
}


TEST(nonlinearSolid, tangentHasFollowerPressureAndTimeScheme)
{
    for (const char* elements : {"linear", "enhancedStrain", "quadratic"})
    {
        SCOPED_TRACE(elements);
        solidCase c;
        cube(c);
        c.pointD +=
            "free { type springs; value uniform (0 0 0); springs"
            " { n { direction (1 2 3); stiffness 30; damping 4; } all { damping 2; } } }";
        c.elements = elements;
        c.timeScheme = "type generalisedAlpha; rhoInf 0.5;";
        c.make();
        c.next();

        Foam::Random random(1);
        scalarField x(c.nUnknowns()), dx(x);
        for (scalar& s : x) s = 0.3*random.GaussNormal<scalar>();
        for (scalar& s : dx) s = random.GaussNormal<scalar>();
        c.update(x);

        EXPECT_LT(c.tangentError(dx), 1e-6);
    }
}


//- A linear displacement on distorted cells stays one, of all elements
TEST(nonlinearSolid, constantStrainIsExact)
{
    const char* const mixed = "rubber { type isochoricNeoHookean; rho 1; mu 40; bulkModulus 100; }";
    struct { const char* elements; const char* materials; } runs[] =
    {
        {"linear", nullptr}, {"enhancedStrain", nullptr}, {"quadratic", nullptr},
        {"Q1Q0", mixed}, {"equalOrder", mixed}, {"taylorHood", mixed}
    };
    for (const auto& run : runs)
    {
        SCOPED_TRACE(run.elements);
        solidCase c;
        cube(c);
        c.elements = run.elements;
        if (run.materials) c.materials = run.materials;
        c.pointD = "\".*\" { type fixedValue; value uniform (0 0 0); }";
        c.make();
        const tensor H(0.2, 0.1, -0.05, 0.03, -0.1, 0.2, 0.1, 0, 0.15);
        motionField& motion = c.solid->motion();
        const vectorField exact(H & c.solid->fe().points());
        forAll(exact, n) motion.D[n] = exact[n];
        c.residual();
        scalarField x(c.nUnknowns(), 0.01);
        forAll(x, u) if (!c.isFree(u)) x[u] = 0;
        c.update(x);
        EXPECT_GT(c.solve(), 0);
        EXPECT_LT(max(mag(motion.D - exact)), 1e-11);
    }
}


//- r_k+1 < C r_k^2 at strains of a third, with every law of the selection table
TEST(nonlinearSolid, convergesWithSecondOrderWithEveryLaw)
{
    for (const word& type : allMaterials())
    {
        SCOPED_TRACE(type);
        solidCase c;
        cube(c);
        OStringStream law;
        exampleDict(type).write(law, false);
        c.materials = "body { " + law.str() + " }";
        c.elements = "quadratic";
        const std::string side = " (4 5 6 7)";
        c.blockMesh.erase(c.blockMesh.find(side), side.size());
        c.pointD += "loaded { type fixedValue; value uniform (0.3 0.1 0); }";
        c.make();

        // As moved, with what is inside where it comes to rest
        c.next();
        motionField& motion = c.solid->motion();
        const vectorField& X = c.solid->fe().points();
        forAll(X, n) if (c.isFree(c.solid->unknowns().start(0, n))) motion.D[n] = X[n].x()*vector(0.3, 0.1, 0);
        EXPECT_GT(c.solve(), 0);
        label nPairs = 0;
        std::string all;
        for (const scalar r : c.norms) all += " " + std::to_string(r/c.norms[0]);
        for (label k = 0; k + 1 < c.norms.size(); ++k)
        {
            const scalar a = c.norms[k]/c.norms[0], b = c.norms[k + 1]/c.norms[0];
            if (a > 0.05 || a < 1e-7) continue;
            ++nPairs;
            EXPECT_LT(b, 100*a*a + 1e-12) << all;
        }
        EXPECT_TRUE(nPairs > 0 || type == "linearElastic") << all;
    }
}


//- A block on springs of a foundation, under a traction: rigid beside them, it
//  gives way by the traction over the springs' stiffness
TEST(nonlinearSolid, restsOnSprings)
{
    solidCase c;
    c.blockMesh =
        "vertices ((0 0 0) (1 0 0) (1 1 0) (0 1 0) (0 0 1) (1 0 1) (1 1 1) (0 1 1));"
        "blocks (hex (0 1 2 3 4 5 6 7) (2 2 2) simpleGrading (1 1 1)); boundary ("
        "foot { type patch; faces ((0 1 5 4)); } top { type patch; faces ((3 2 6 7)); });"
        "defaultPatch { name free; type patch; }";
    c.materials = "rigid { type StVenantKirchhoff; rho 1; E 1e9; nu 0; }";
    c.pointD =
        "foot { type springs; springs { a { direction (0 2 0); stiffness 100; } b { stiffness 50; } }"
        " value uniform (0 0 0); } free { type calculated; value uniform (0 0 0); }"
        "top { type traction; traction constant (0 -3 0); value uniform (0 0 0); }";
    for (const char* elements : {"linear", "quadratic"})
    {
        solidCase again;
        again.blockMesh = c.blockMesh;
        again.materials = c.materials;
        again.pointD = c.pointD;
        again.elements = elements;
        again.make();
        again.next();
        EXPECT_GT(again.solve(), 0);
        for (const vector& D : again.solid->motion().D) EXPECT_LT(mag(D - vector(0, -0.02, 0)), 1e-7);
    }
}


TEST(nonlinearSolid, springsAreComplainedAbout)
{
    struct { const char* springs; const char* message; } cases[] =
    {
        {"springs { }", "No spring in springs"},
        {"springs { a 1; }", "is no dictionary, expected"},
        {"springs { a { } }", "one that is positive"},
        {"springs { a { stiffness -1; damping 2; } }", "not negative"},
        {"springs { a { direction (0 0 0); stiffness 1; } }", "a vector that is not nil"},
    };
    for (const auto& wrong : cases)
    {
        solidCase c;
        cube(c);
        c.pointD = "\".*\" { type springs; value uniform (0 0 0); " + std::string(wrong.springs) + " }";
        expectComplaint(c, wrong.message);
    }
}


//- Pressure on a closed surface has no resultant, however it is deformed
TEST(nonlinearSolid, pressureFollowsTheSurface)
{
    solidCase c;
    cube(c);
    c.elements = "quadratic";
    c.pointD =
        "clamp { type followerPressure; pressure constant 3; value uniform (0 0 0); }"
        "free { type followerPressure; pressure constant 3; value uniform (0 0 0); }"
        "loaded { type followerPressure; pressure constant 3; value uniform (0 0 0); }";
    c.make();
    Foam::Random random(2);
    scalarField x(c.nUnknowns());
    for (scalar& s : x) s = 0.05*random.GaussNormal<scalar>();
    c.next();
    c.update(x);
    c.residual();
    EXPECT_LT(mag(sum(c.solid->force())), 1e-12);
    const scalar inside = mag(gSum(mag(c.solid->force())()));
    EXPECT_GT(inside, 1);
}


TEST(nonlinearSolid, takesAForceDensity)
{
    solidCase c;
    cube(c);
    c.pointD = "\".*\" { type calculated; value uniform (0 0 0); }";
    c.make();
    c.next();
    c.solid->source = [](const point& X, const scalar t) { return vector(X.x(), 2, t); };
    c.residual();
    const scalar V = gSum(c.solid->mesh().V());
    const vector f = sum(c.solid->force());
    EXPECT_NEAR(f.y(), -2*V, 1e-2*V);
    EXPECT_NEAR(f.z()/f.y(), 0.05, 1e-12);
}


TEST(nonlinearSolid, derivesItsOutput)
{
    solidCase c;
    cook(c, "2", "quadratic");

    // Uniform stretch along y: P33 of plane strain makes part of von Mises'
    motionField& motion = c.solid->motion();
    const scalar F = 1.1, mu = 200/2.7, lambda = 200*0.35/(1.35*0.3);
    forAll(motion.D, n) motion.D[n] = vector(0, (F - 1)*c.solid->fe().points()[n].y(), 0);
    c.solid->derive();

    const fvMesh& mesh = c.solid->mesh();
    const scalar lateral = 0.5*lambda*(F*F - 1)/F, axial = mu*(F - 1/F) + lateral;
    const auto& sigma = mesh.lookupObject<volSymmTensorField>("sigma");
    EXPECT_LT(mag(sigma[0] - symmTensor(lateral, 0, 0, axial, 0, lateral)), 1e-11*axial);
    EXPECT_NEAR(mesh.lookupObject<volScalarField>("sigmaEq")[3], axial - lateral, 1e-11*axial);
    const auto& D = mesh.lookupObject<volVectorField>("D");
    EXPECT_NEAR(D[1].y(), 0.1*mesh.C()[1].y(), 0.1);
    const auto& pointD = mesh.lookupObject<pointVectorField>("pointD");
    forAll(pointD, p) EXPECT_NEAR(pointD[p].y(), 0.1*mesh.points()[p].y(), 1e-12);
}


TEST(nonlinearSolid, hasMaterialsByCellZone)
{
    solidCase c;
    cube(c);
    c.materials = "a { type neoHookean; rho 1; E 1; nu 0; cellZone one; }";
    c.make();
    EXPECT_EQ(c.solid->assembly().blocks().size(), 1);

    solidCase twice, none, unknown, noDict, noType;
    cube(twice);
    twice.materials = c.materials + "b { type neoHookean; rho 1; E 1; nu 0; }";
    expectComplaint(twice, "has the materials 'a' and 'b'");
    cube(none);
    none.materials = "";
    expectComplaint(none, "has no material");
    cube(unknown);
    unknown.materials = "a { type neoHookean; rho 1; E 1; nu 0; cellZone two; }";
    expectComplaint(unknown, "Its cellZones are 1(one)");
    cube(noDict);
    noDict.materials = "a 1;";
    expectComplaint(noDict, "is no list of materials, expected");
    cube(noType);
    noType.materials = "a { type steel; }";
    expectComplaint(noType, "StVenantKirchhoff");
}


//- Uniaxial stress in two bars in a row: their stretches are in the inverse
//  ratio of the moduli
TEST(nonlinearSolid, splitsItsElementsByMaterial)
{
    solidCase c;
    c.blockMesh =
        "vertices ((0 0 0) (1 0 0) (2 0 0) (0 1 0) (1 1 0) (2 1 0)"
        " (0 0 1) (1 0 1) (2 0 1) (0 1 1) (1 1 1) (2 1 1));"
        "blocks (hex (0 1 4 3 6 7 10 9) soft (3 3 3) simpleGrading (1 1 1)"
        " hex (1 2 5 4 7 8 11 10) stiff (3 3 3) simpleGrading (1 1 1));"
        "boundary (clamp { type wall; faces ((0 6 9 3)); } right { type patch; faces ((2 5 11 8)); });"
        "defaultPatch { name free; type patch; }";
    const std::string law = "type StVenantKirchhoff; rho 1; nu 0;";
    c.materials = "a {" + law + "E 100; cellZone soft; } b {" + law + "E 400; cellZone stiff; }";
    c.pointD =
        "clamp { type fixedValue; value uniform (0 0 0); } free { type calculated; value uniform (0 0 0); }"
        "right { type traction; traction constant (1e-3 0 0); value uniform (0 0 0); }";
    c.make();
    EXPECT_EQ(c.solid->assembly().blocks().size(), 2);
    c.next();
    EXPECT_GT(c.solve(), 0);
    EXPECT_NEAR(c.displacement({1, 0, 0}).x(), 1e-5, 1e-9);
    EXPECT_NEAR(c.displacement({2, 0, 0}).x(), 1.25e-5, 1e-9);
}


TEST(nonlinearSolid, listsTheKindsOfElements)
{
    solidCase c;
    cube(c);
    c.elements = "cubic";
    expectComplaint(c, "enhancedStrain");
}


// ************************************************************************* //
