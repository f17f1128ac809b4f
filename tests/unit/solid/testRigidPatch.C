/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Tests of patches that are rigid bodies: rotations, their nodes and tangent
    in large rotations, wrong entries.
\*---------------------------------------------------------------------------*/

#include "solidCase.H"
#include "rotation.H"
#include "Random.H"

using namespace Foam;

namespace
{

void block(solidCase& c, const std::string& patch)
{
    c.blockMesh =
        "vertices ((0 0 0) (1 0.1 0) (1 1 0) (0 1 0.1) (0 0 1) (1 0 1) (1.2 1 1) (0 1 1));"
        "blocks (hex (0 1 2 3 4 5 6 7) one (2 2 2) simpleGrading (1 1 1)); boundary ("
        "clamp { type wall; faces ((0 4 7 3)); } rigid { type patch; faces ((1 2 6 5)); });"
        "defaultPatch { name free; type patch; }";
    c.materials = "rubber { type neoHookean; rho 3; E 100; nu 0.3; }";
    c.timeScheme = "type generalisedAlpha; rhoInf 0.5;";
    c.pointD =
        "clamp { type fixedValue; value uniform (0 0 0); } free { type calculated; value uniform (0 0 0); }"
        "rigid { type rigidPatch; " + patch + " value uniform (0 0 0); }";
}

const char* const loose =
    "translation { x { force 2; } y { force 1; } z { force -1; } }"
    "rotation { x { moment 0.5; } y { moment 1; } z { moment table ((0 0) (1 3)); } }";

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(rotation, hasInverseAndDerivatives)
{
    Foam::Random random(3);
    for (const scalar length : {0.0, 1e-9, 1e-4, 0.099, 0.101, 1.0, 3.0})
    {
        SCOPED_TRACE(length);
        vector w(random.GaussNormal<vector>());
        w *= length/mag(w);
        const tensor R(rotation::exp(w));
        EXPECT_LT(mag((R & R.T()) - tensor::I), 1e-14);
        EXPECT_LT(mag(rotation::log(R) - w), 1e-13 + 1e-12*length);
        for (label j = 0; j < 3; ++j)
        {
            const scalar h = 1e-4;
            const vector e(h*rotation::axis(j));
            const tensor central((rotation::exp(w + e) - rotation::exp(w - e))/(2*h));
            EXPECT_LT(mag(central - rotation::dexp(w, j)), 1e-8);
        }
    }
}


//- With mass and inertia, in the middle of a step that turns it far
TEST(rigidPatch, hasItsTangent)
{
    for (const char* scheme : {"type generalisedAlpha; rhoInf 0.5;", "type Euler;", "type steady;"})
    {
        for (const std::string& directions : {std::string(loose), std::string("rotation { y { moment 1; } }")})
        {
            SCOPED_TRACE(scheme + directions);
            solidCase c;
            block(c, directions + "mass 2; inertia (1 0.1 0 1.5 0 1.2);");
            c.timeScheme = scheme;
            c.make();
            Foam::Random random(1);
            scalarField x(c.nUnknowns()), dx(x);
            const scalar size = c.solid->timeScheme().steady() ? 0.05 : 2;
            for (label step = 0; step < 2; ++step)
            {
                c.next();
                c.residual();
                for (scalar& s : x) s = size*random.GaussNormal<scalar>();
                c.update(x);
            }

            for (scalar& s : dx) s = random.GaussNormal<scalar>();
            // Nodes, and the body, whose numbers are the last
            const label nodes = c.nUnknowns() - 6;
            for (const bool body : {false, true})
            {
                EXPECT_LT(c.tangentError(dx, [&](const label u) { return (u >= nodes) == body; }), 1e-6);
            }
        }
    }
}


//- All distances on the patch are kept
TEST(rigidPatch, isRigid)
{
    solidCase c;
    block(c, loose);
    c.elements = "quadratic";
    c.make();
    const feMesh& fe = c.solid->fe();
    const labelList& nodes = fe.patchNodes(c.solid->mesh().boundaryMesh().findPatchID("rigid"));
    EXPECT_EQ(nodes.size(), 25);
    for (label step = 0; step < 3; ++step)
    {
        c.next();
        EXPECT_GT(c.solve(), 0);
        const vectorField x(fe.points() + c.solid->motion().D);
        for (const label m : nodes) for (const label n : nodes)
        {
            EXPECT_NEAR(mag(x[m] - x[n]), mag(fe.points()[m] - fe.points()[n]), 1e-14);
        }
    }
    EXPECT_GT(mag(c.solid->rigidMotions()[0].rotation), 1e-3);
}


TEST(rigidPatch, isComplainedAbout)
{
    struct { const char* patch; const char* message; } cases[] =
    {
        {"translation { w { force 1; } }", "Found entry 'w' in translation, expected directions"},
        {"rotation { x 1; }", "Found entry 'x' in rotation, expected directions"},
        {"translation { x { } }", "neither force nor motion of direction x"},
        {"rotation { z { moment 1; motion 0; } }", "both moment and motion of direction z"},
        {"translation { z { moment 1; } }", "neither force nor motion of direction z"},
        {"mass -1;", "mass"},
        {"inertia (1 0 0 1 0 3);", "nor larger than the sum of the other two"},
        {"inertia (-1 0 0 1 0 1);", "principal moment negative"},
        {"centre 3;", "Expected a '('"},
    };
    for (const auto& wrong : cases)
    {
        SCOPED_TRACE(wrong.message);
        solidCase c;
        block(c, wrong.patch);
        expectComplaint(c, wrong.message);
    }
}
