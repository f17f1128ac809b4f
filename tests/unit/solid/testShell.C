/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Tests of solid-shells: patch tests, bending of thin strips, which side is the
    thickness. What they share with all elements is in testElements.C.
\*---------------------------------------------------------------------------*/

#include "elementPatch.H"
#include "shellLoop.H"
#include "IStringStream.H"
#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- Five elements through a plate: R.H. MacNeal, R.L. Harder, Finite Elem. Anal.
//  Des. 1 (1985) 3-20. Nodes 4 .. 7 and 12 .. 15 are inside
elementPatch platePatch(const solidMaterial& law, const scalar thickness)
{
    vectorField X
    ({
        {0, 0, 0}, {0.24, 0, 0}, {0.24, 0.12, 0}, {0, 0.12, 0},
        {0.04, 0.02, 0}, {0.18, 0.03, 0}, {0.16, 0.08, 0}, {0.08, 0.08, 0}
    });
    X.append(vectorField(X + vector(0, 0, thickness)));
    const label quads[5][4] = {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}};
    labelList nodes;
    for (const auto& quad : quads)
    {
        for (const label n : quad) nodes.append(n);
        for (const label n : quad) nodes.append(n + 8);
    }
    return elementPatch(law, elementShape::HEX, 1, X, nodes);
}


//- The largest sum of the forces at the two ends of an inner edge, by the largest
//  force: what acts on the plate's two sides is opposite
scalar unbalanced(elementPatch patch, const vectorField& D)
{
    patch.beShell();
    patch.stage.D = D;
    const vectorField f(patch.toNodes(patch.force()));
    scalar sum = 0;
    for (label n = 4; n < 8; ++n) sum = max(sum, mag(f[n] + f[n + 8]));
    return sum/max(mag(f));
}


//- Solve for the inner nodes, those of the boundary being given. The largest
//  deviation, by the largest displacement
scalar deviation(elementPatch patch, const vectorField& exact)
{
    patch.beShell();
    labelList fixed;
    for (label n = 0; n < 16; ++n) if (n%8 < 4) for (label a = 0; a < 3; ++a) fixed.append(3*n + a);
    patch.stage.D = exact;
    for (label n = 0; n < 16; ++n) if (n%8 >= 4) patch.stage.D[n] *= 0.9;
    patch.solve(Eigen::VectorXd::Zero(patch.nUnknowns()), fixed);
    return max(mag(patch.stage.D - exact))/max(mag(exact));
}


//- Tip of a strip of some elements, clamped, of length 1, under an end load of P
//  L^2/(EI) = 4, by that of the elastica
scalar elastica(const bool shell, const scalar thickness)
{
    const scalar E = 12/pow3(thickness);
    const label n = 20;
    IStringStream is("type StVenantKirchhoff; rho 1; nu 0; E " + std::to_string(E) + ";");
    const autoPtr<solidMaterial> law = solidMaterial::New(dictionary(is));
    vectorField X;
    labelList nodes, fixed;
    for (label i = 0; i <= n; ++i)
    {
        for (const scalar z : {0.0, 1.0}) for (const scalar y : {0.0, 1.0})
        {
            if (i == 0) for (label a = 0; a < 3; ++a) fixed.append(3*X.size() + a);
            X.append(vector(i/scalar(n), y, z*thickness));
        }
    }
    for (label i = 0; i < n; ++i) for (const label k : {0, 4, 5, 1, 2, 6, 7, 3}) nodes.append(4*i + k);
    elementPatch patch(law(), elementShape::HEX, 1, X, nodes);
    if (shell) patch.beShell();
    vectorField f(X.size(), Zero);
    for (label step = 1; step <= 8; ++step)
    {
        for (label k = 4*n; k < 4*n + 4; ++k) f[k] = vector(0, 0, 4*step/8.0/4);
        if (patch.solve(patch.toUnknowns(f), fixed) < 0) return -1;
    }
    return patch.stage.D.last().z()/0.66996;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(solidShell, constantStrainIsExact)
{
    const tensor H(0.2, 0.1, -0.05, -0.15, 0.1, 0.08, 0.04, 0.07, -0.12);
    for (const word& type : objectiveMaterials())
    {
        SCOPED_TRACE(type);
        const autoPtr<solidMaterial> law = exampleMaterial(type);
        EXPECT_LT(unbalanced(platePatch(law(), 0.01), H & platePatch(law(), 0.01).X()), 1e-11);
    }
}


//- Bending with one curvature along a direction that is oblique to the elements
TEST(solidShell, constantBendingIsExact)
{
    IStringStream is("type StVenantKirchhoff; rho 1; nu 0.3; E 1e6;");
    const autoPtr<solidMaterial> law = solidMaterial::New(dictionary(is));
    const scalar thickness = 0.001;
    const vectorField X(platePatch(law(), thickness).X());
    vectorField exact(X.size());
    forAll(X, n)
    {
        // w = 1e-8 (x^2 + xy + y^2)/2 and stress nil across the thickness
        const scalar x = X[n].x(), y = X[n].y(), z = X[n].z() - 0.5*thickness;
        exact[n] = 1e-8*vector
        (
            -z*(x + 0.5*y), -z*(y + 0.5*x), 0.5*(x*x + x*y + y*y) + 0.3/0.7*z*z
        );
    }
    EXPECT_LT(deviation(platePatch(law(), thickness), exact), 1e-5);
}


TEST(solidShell, bendsWhereLinearElementsLock)
{
    for (const scalar thickness : {0.02, 0.005})
    {
        const scalar shell = elastica(true, thickness), linear = elastica(false, thickness);
        Info<< "    strip of 20 elements of " << thickness << ": solid-shell " << shell
            << ", linear " << linear << " of the elastica" << endl;
        EXPECT_NEAR(shell, 1, 0.01);
        EXPECT_LT(linear, 0.5);
    }
}


TEST(solidShell, findsItsThickness)
{
    const vectorField box
    ({
        {0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 0}, {0, 0, 3}, {1, 0, 3}, {1, 2, 3}, {0, 2, 3}
    });
    for (label thin = 0; thin < 3; ++thin)
    {
        vectorField X(box);
        for (vector& x : X) x[thin] *= 0.1;
        elementBlock block;
        block.shape = elementShape::HEX;
        block.order = 1;
        block.nNodes = 8;
        block.nodes = identity(8);
        block.cells = identity(1);
        shellLoop::thicknessLast(X, block);
        const label* n = block.element(0);
        const vector a(X[n[1]] - X[n[0]]), b(X[n[3]] - X[n[0]]), c(X[n[4]] - X[n[0]]);
        EXPECT_GT((a ^ b) & c, 0);
        EXPECT_NEAR(mag(c[thin]), mag(c), 1e-15);
    }
}


// ************************************************************************* //
