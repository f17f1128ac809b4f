/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Tests of the enhanced strain: patch test, bending, internal parameters
    that do not converge.
\*---------------------------------------------------------------------------*/

#include "elementPatch.H"
#include "IStringStream.H"
#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- Five quadrilaterals round a distorted one: R.H. MacNeal, R.L. Harder,
//  Finite Elem. Anal. Des. 1 (1985) 3-20. Inner nodes 4..7
elementPatch quadPatch(const solidMaterial& law)
{
    const vectorField X
    ({
        {0, 0, 0}, {0.24, 0, 0}, {0.24, 0.12, 0}, {0, 0.12, 0},
        {0.04, 0.02, 0}, {0.18, 0.03, 0}, {0.16, 0.08, 0}, {0.08, 0.08, 0}
    });
    return elementPatch
    (
        law, elementShape::QUAD, 1, X,
        {0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7, 4, 5, 6, 7}
    );
}


//- Seven hexahedra round a distorted one: ibid. Inner nodes 8..15
elementPatch hexPatch(const solidMaterial& law)
{
    const vectorField X
    ({
        {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1},
        {0.249, 0.342, 0.192}, {0.826, 0.288, 0.288}, {0.850, 0.649, 0.263}, {0.273, 0.750, 0.230},
        {0.320, 0.186, 0.643}, {0.677, 0.305, 0.683}, {0.788, 0.693, 0.644}, {0.165, 0.745, 0.702}
    });
    return elementPatch
    (
        law, elementShape::HEX, 1, X,
        {
            8, 9, 10, 11, 12, 13, 14, 15,
            0, 1, 2, 3, 8, 9, 10, 11,
            12, 13, 14, 15, 4, 5, 6, 7,
            0, 1, 9, 8, 4, 5, 13, 12,
            1, 2, 10, 9, 5, 6, 14, 13,
            2, 3, 11, 10, 6, 7, 15, 14,
            3, 0, 8, 11, 7, 4, 12, 15
        }
    );
}


void checkPatch(elementPatch patch, const label nOuter)
{
    const label dim = patch.dim();
    tensor H(0.2, 0.1, -0.05, -0.15, 0.1, 0.08, 0.04, 0.07, -0.12);
    if (dim == 2) H = tensor(0.2, 0.1, 0, -0.15, 0.1, 0, 0, 0, 0);
    const vectorField exact(H & patch.X());

    patch.stage.enhanced = true;
    patch.stage.D = exact;
    for (label n = nOuter; n < exact.size(); ++n) patch.stage.D[n] = 0.7*exact[n];
    const label nIter = patch.solve(Eigen::VectorXd::Zero(patch.nUnknowns()), identity(nOuter*dim));

    EXPECT_GT(nIter, 0);
    EXPECT_LT(max(mag(patch.stage.D - exact)), 1e-12);
}


//- Pure bending of a cantilever of two elements, length 10, height 2 (depth 1),
//  whose common edge is slanted by the distortion a: T.H.H. Pian, K. Sumihara,
//  Int. J. Numer. Meth. Engng 20 (1984) 1685-1695. Deflection of the tip
//  against that of the beam, M L^2/(2 E' I)
scalar bending(const label dim, const scalar a, const bool enhanced)
{
    const scalar E = 1500, nu = 0.25, load = 1e-4;
    IStringStream is("type neoHookean; rho 1; E 1500; nu 0.25;");
    const autoPtr<solidMaterial> law = solidMaterial::New(dictionary(is));

    vectorField X({{0, 0, 0}, {5 + a, 0, 0}, {10, 0, 0}, {0, 2, 0}, {5 - a, 2, 0}, {10, 2, 0}});
    labelList nodes({0, 1, 4, 3, 1, 2, 5, 4});
    labelList fixed({0, 1, 6});
    if (dim == 3)
    {
        vectorField back(X + vector(0, 0, 1));
        X.append(back);
        nodes = {0, 1, 4, 3, 6, 7, 10, 9, 1, 2, 5, 4, 7, 8, 11, 10};
        // Clamped against x; plane strain
        fixed = {0, 1, 9, 18, 19, 27};
        for (label n = 0; n < 12; ++n) fixed.append(3*n + 2);
    }
    elementPatch patch(law(), dim == 2 ? elementShape::QUAD : elementShape::HEX, 1, X, nodes);
    patch.stage.enhanced = enhanced;

    vectorField f(X.size(), Zero);
    forAll(X, n) if (X[n].x() > 9.9) f[n].x() = (X[n].y() > 1 ? -load : load)/(dim - 1);
    if (patch.solve(patch.toUnknowns(f), fixed) < 0) return -1;

    const scalar M = 2*load, I = 8.0/12;
    return patch.stage.D[2].y()/(M*100/(2*E/(1 - nu*nu)*I));
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(enhancedStrain, constantStrainIsExact)
{
    for (const word& type : allMaterials())
    {
        SCOPED_TRACE(type);
        const autoPtr<solidMaterial> law = exampleMaterial(type);
        checkPatch(quadPatch(law()), 4);
        checkPatch(hexPatch(law()), 8);
    }
}


TEST(enhancedStrain, bendsWhereLinearElementsLock)
{
    for (const label dim : {2, 3})
    {
        SCOPED_TRACE(dim);
        for (const scalar a : {0, 1, 2})
        {
            const scalar Q1 = bending(dim, a, false), enhanced = bending(dim, a, true);
            Info<< "    bending in " << dim << "-D, distortion " << a << ": linear " << Q1
                << ", enhanced " << enhanced << " of the beam" << endl;
            if (a == 0)
            {
                EXPECT_NEAR(enhanced, 1, 1e-4);
            }
            EXPECT_GT(enhanced, 3*Q1);
        }
    }
}


//- Wide strain, where parameters start far from their values
TEST(enhancedStrain, convergesAtLargeStrain)
{
    const autoPtr<solidMaterial> law = exampleMaterial("neoHookean");
    for (const scalar stretch : {0.4, 0.7, 2.0, 4.0})
    {
        elementPatch patch = elementPatch::distorted<Hex1>(law(), elementShape::HEX, packSize);
        patch.stage.enhanced = true;
        patch.stage.D = cmptMultiply(vector(stretch - 1, 0, 0), patch.X());
        Random random(6);
        for (vector& D : patch.stage.D) D += 0.1*(random.sample01<vector>() - vector(0.5, 0.5, 0.5));
        patch.force();
        EXPECT_GT(patch.minDetJ(), 0) << stretch;
    }
}


// ************************************************************************* //
