/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Tests of patches that touch a rigid surface: tangents of all surfaces, a block
    pressed on one of each, wrong entries.
\*---------------------------------------------------------------------------*/

#include "solidCase.H"
#include "rigidSurface.H"
#include "IStringStream.H"
#include "Random.H"

using namespace Foam;

namespace
{

const char* const flat = "{ type plane; point (0 0 0); normal (0 2 0); }";

//- A block that can only change its height, under a pressure on its top
void block(solidCase& c, const std::string& contact)
{
    c.blockMesh =
        "vertices ((0 0 0) (1 0 0) (1 1 0) (0 1 0) (0 0 1) (1 0 1) (1 1 1) (0 1 1));"
        "blocks (hex (0 1 2 3 4 5 6 7) (2 2 2) simpleGrading (2 3 1)); boundary ("
        "foot { type patch; faces ((0 1 5 4)); } top { type patch; faces ((3 2 6 7)); });"
        "defaultPatch { name sides; type patch; }";
    c.materials = "rubber { type neoHookean; rho 1000; E 100; nu 0.3; }";
    c.pointD =
        "foot { type rigidContact; value uniform (0 0 0); " + contact + "}"
        "top { type traction; traction constant (0 -3 0); value uniform (0 0 0); }"
        "sides { type slip; value uniform (0 0 0); }";
}

supportTotals foot(const solidCase& c)
{
    return c.solid->supportOf(c.solid->mesh().boundaryMesh().findPatchID("foot"));
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

//- Gradients of the way to a surface; of both sides
TEST(rigidContact, surfacesHaveTheirGradients)
{
    const char* surfaces[] =
    {
        "type plane; point (1 2 3); normal (1 -2 0.5);",
        "type sphere; centre (1 2 3); radius 0.7;",
        "type sphere; centre (1 2 3); radius 7; side inside;",
        "type cylinder; point (1 2 3); axis (1 1 0.2); radius 0.7; side outside;",
        "type cylinder; point (1 2 3); axis (1 1 0.2); radius 7; side inside;"
    };
    for (const char* entries : surfaces)
    {
        SCOPED_TRACE(entries);
        IStringStream is(entries);
        const autoPtr<rigidSurface> surface(rigidSurface::New(dictionary(is)));
        const point x(0.3, 1.2, 0.7);
        const rigidSurface::distance at = surface->at(x);
        EXPECT_NEAR(mag(at.normal), 1, 1e-14);
        for (direction c = 0; c < 3; ++c)
        {
            vector h = Zero;
            h[c] = 1e-6;
            const rigidSurface::distance up = surface->at(x + h), down = surface->at(x - h);
            EXPECT_NEAR((up.gap - down.gap)/2e-6, at.normal[c], 1e-8);
            EXPECT_LT(mag((up.normal - down.normal)/2e-6 - (at.dNormal & (h/1e-6))), 1e-8);
        }
        EXPECT_LT(mag(surface->at(x - at.gap*at.normal).gap), 1e-13);
    }
}


TEST(rigidContact, hasItsTangent)
{
    const char* surfaces[] =
    {
        "{ type plane; point (0 0.02 0); normal (0.1 1 0.2); }",
        "{ type sphere; centre (0.5 -1 0.5); radius 1.1; }",
        "{ type cylinder; point (0.5 1 0); axis (0 0.1 1); radius 1.1; side inside; }"
    };
    for (const char* elements : {"linear", "quadratic"}) for (const char* surface : surfaces)
    {
        SCOPED_TRACE(std::string(elements) + surface);
        solidCase c;
        block(c, std::string("surface ") + surface + "; penalty 300; displacement constant (0 0.03 0.01);");
        c.elements = elements;
        c.timeScheme = "type generalisedAlpha; rhoInf 0.5;";
        c.make();
        c.next();

        Foam::Random random(1);
        scalarField x(c.nUnknowns()), dx(x);
        for (scalar& s : x) s = 0.2*random.GaussNormal<scalar>();
        for (scalar& s : dx) s = random.GaussNormal<scalar>();
        c.update(x);
        c.residual();
        EXPECT_GT(foot(c).area, 0.05);
        EXPECT_LT(c.tangentError(dx), 1e-6);
    }
}


//- All elements: the pressure is the same all over the foot, which has gone as
//  far into the surface
TEST(rigidContact, pressureUnderABlockIsUniform)
{
    struct { const char* elements; const char* material; } runs[] =
    {
        {"linear", ""}, {"enhancedStrain", ""}, {"quadratic", ""},
        {"Q1Q0", "rubber { type isochoricNeoHookean; rho 1; mu 40; bulkModulus 100; }"},
        {"taylorHood", "rubber { type isochoricNeoHookean; rho 1; mu 40; bulkModulus 100; }"}
    };
    for (const auto& run : runs)
    {
        // The second surface comes to the block
        for (const char* place : {"(0 0 0)", "(0 -0.2 0)"})
        {
            SCOPED_TRACE(std::string(run.elements) + place);
            solidCase c;
            block
            (
                c, std::string("surface { type plane; point ") + place + "; normal (0 1 0); } penalty 2000;"
                "displacement table ((0 (0 0 0)) (0.1 (0 0.1 0)));"
            );
            c.elements = run.elements;
            if (*run.material) c.materials = run.material;
            if (place[3] == '-') c.pointD += "top { type fixedValue; value uniform (0 -0.2 0); }";
            c.make();
            c.next();
            EXPECT_GT(c.solve(), 0);
            c.residual();
            const supportTotals sum = foot(c);
            EXPECT_NEAR(sum.area, 1, 1e-12);
            EXPECT_NEAR(sum.force.y(), sum.traction, 1e-8*sum.traction);
            EXPECT_LT(mag(sum.force.x()) + mag(sum.force.z()), 1e-10);
            EXPECT_NEAR(sum.gap, -sum.traction/2000, 1e-12);
            if (place[3] == '-') EXPECT_GT(sum.traction, 1);
            else EXPECT_NEAR(sum.traction, 3, 1e-8);
        }
    }
}


TEST(rigidContact, isNotThereWhileTheyAreApart)
{
    solidCase c;
    block(c, "surface { type plane; point (0 -1 0); normal (0 1 0); } penalty 1e3;");
    c.pointD += "top { type fixedValue; value uniform (0 0 0); }";
    c.make();
    c.next();
    c.residual();
    EXPECT_EQ(foot(c).area, 0);
    EXPECT_EQ(mag(foot(c).force), 0);
    EXPECT_NEAR(foot(c).gap, 1, 1e-14);
}


TEST(rigidContact, isComplainedAbout)
{
    const std::string plane = std::string("surface ") + flat, penalty = "penalty 1;";
    struct { std::string contact; const char* message; } cases[] =
    {
        {penalty, "surface"},
        {plane, "penalty"},
        {plane + "penalty -1;", "penalty"},
        {penalty + "surface { type torus; }", "cylinder"},
        {penalty + "surface { type plane; point (0 0 0); normal (0 0 0); }", "a vector that is not nil"},
        {penalty + "surface { type sphere; centre (0 0 0); radius 0; }", "radius"},
        {penalty + "surface { type sphere; centre (0 0 0); radius 1; side left; }", "outside or inside"},
        {penalty + "surface { type cylinder; point (0 0 0); axis (0 0 0); radius 1; }", "a vector that is not nil"}
    };
    for (const auto& wrong : cases)
    {
        solidCase c;
        block(c, wrong.contact);
        expectComplaint(c, wrong.message);
    }

    const char* inPlane[] =
    {
        "type sphere; centre (0 0 0); radius 1;", "type plane; point (0 0 0); normal (0 1 1);",
        "type cylinder; point (0 0 0); axis (0 1 1); radius 1;"
    };
    for (const char* surface : inPlane)
    {
        solidCase c;
        c.blockMesh =
            "vertices ((0 0 0) (1 0 0) (1 1 0) (0 1 0) (0 0 1) (1 0 1) (1 1 1) (0 1 1));"
            "blocks (hex (0 1 2 3 4 5 6 7) (1 1 1) simpleGrading (1 1 1)); boundary ("
            + std::string(twoDimensional) + "); defaultPatch { name foot; type patch; }";
        c.materials = "rubber { type neoHookean; rho 1000; E 100; nu 0.3; }";
        c.pointD =
            "foot { type rigidContact; value uniform (0 0 0); penalty 1; surface {" + std::string(surface)
          + "} } plane { type empty; }";
        expectComplaint(c, "the normal of a 2-D case");
    }
}


// ************************************************************************* //
