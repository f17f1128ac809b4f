/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Tests of the kernels of all elements with all materials.
\*---------------------------------------------------------------------------*/

#include "elementPatch.H"
#include "shellLoop.H"
#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- More than one batch, and one that is not full
const label nElements = packSize + 3;

//- Call f(patch, name) for all elements, for those that have them also with
//  enhanced strains, and for solid-shells
template<class F>
void forElements(const solidMaterial& law, const F& f)
{
    const auto test = [&](const auto E, const elementShape shape, const bool enhanced, const bool shell = false)
    {
        typedef typename std::decay<decltype(E)>::type element;
        elementPatch patch = elementPatch::distorted<element>(law, shape, nElements);
        patch.stage.enhanced = enhanced;
        if (shell && !shellLoop::suits(law)) return;
        if (shell) patch.beShell();
        SCOPED_TRACE(std::string(element::name) + (enhanced ? " enhanced" : shell ? " shell" : ""));
        f(patch);
    };
    test(Tri1(), elementShape::TRI, false);
    test(Tri2(), elementShape::TRI, false);
    test(Quad1(), elementShape::QUAD, false);
    test(Quad2(), elementShape::QUAD, false);
    test(Tet1(), elementShape::TET, false);
    test(Tet2(), elementShape::TET, false);
    test(Hex1(), elementShape::HEX, false);
    test(Hex2(), elementShape::HEX, false);
    test(Prism1(), elementShape::PRISM, false);
    test(Pyramid1(), elementShape::PYRAMID, false);
    test(Quad1(), elementShape::QUAD, true);
    test(Hex1(), elementShape::HEX, true);
    test(Hex1(), elementShape::HEX, false, true);
}

template<class F>
void forMaterialsAndElements(const F& f, const wordList& materials = allMaterials())
{
    for (const word& type : materials)
    {
        SCOPED_TRACE(type);
        const autoPtr<solidMaterial> law = exampleMaterial(type);
        forElements(law(), f);
    }
}

Eigen::VectorXd randomUnknowns(const elementPatch& patch, Random& random, const scalar size)
{
    Eigen::VectorXd x(patch.nUnknowns());
    for (label u = 0; u < x.size(); ++u) x[u] = size*random.GaussNormal<scalar>();
    return x;
}

//- Rotation about an axis (in 2-D: out of the plane)
tensor rotation(const elementPatch& patch, const scalar angle)
{
    vector n = patch.dim() == 2 ? vector(0, 0, 1) : vector(1, 2, 3);
    n /= mag(n);
    const tensor W(0, -n.z(), n.y(), n.z(), 0, -n.x(), -n.y(), n.x(), 0);
    return tensor::I + ::sin(angle)*W + (1 - ::cos(angle))*(W & W);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(solidElement, tangentIsTheDerivativeOfTheResidual)
{
    Random random(1);
    forMaterialsAndElements([&](elementPatch& patch)
    {
        patch.stage.g = vector(1, -2, 0.5);
        patch.stage.dDdu = 0.3;
        patch.stage.dadu = 7;
        const Eigen::VectorXd u = randomUnknowns(patch, random, 0.07);
        const Eigen::VectorXd du = randomUnknowns(patch, random, 1);
        const auto setUnknowns = [&](const Eigen::VectorXd& x)
        {
            patch.stage.D = patch.toNodes(patch.stage.dDdu*x);
            patch.stage.a = patch.toNodes(patch.stage.dadu*x);
        };

        const scalar h = 1e-5;
        setUnknowns(u + h*du);
        const Eigen::VectorXd Rp = patch.force();
        setUnknowns(u - h*du);
        const Eigen::VectorXd Rm = patch.force();
        setUnknowns(u);
        const Eigen::MatrixXd K = patch.tangent();
        ASSERT_GT(patch.minDetJ(), 0);

        const Eigen::VectorXd KdU = K*du, difference = (Rp - Rm)/(2*h) - KdU;
        EXPECT_LT(difference.norm(), 1e-6*KdU.norm());
        EXPECT_LT((K - K.transpose()).norm(), 1e-13*K.norm());
    });
}


TEST(solidElement, inertiaAndWeightAddUp)
{
    forMaterialsAndElements([&](elementPatch& patch)
    {
        patch.stage.g = vector(0, 2, 0);
        patch.stage.a = vector(0, 5, 0);
        patch.stage.dDdu = 0;
        patch.stage.dadu = 1;
        const vectorField unit(patch.X().size(), vector(0, 1, 0));
        const Eigen::VectorXd y = patch.toUnknowns(unit);
        const scalar mass = y.dot(patch.tangent()*y);
        EXPECT_GT(mass, 0);
        EXPECT_NEAR(y.dot(patch.force()), 3*mass, 1e-12*mass);
    });
}


TEST(solidElement, rigidMotionMakesNoForce)
{
    forMaterialsAndElements([&](elementPatch& patch)
    {
        const scalar stiffness = patch.tangent().norm();
        for (const scalar angle : {1.1, 3.1, 12.5})
        {
            const tensor Q = rotation(patch, angle);
            patch.stage.D = (Q & patch.X()) - patch.X() + vector(1, 2, 0);
            EXPECT_LT(patch.force().norm(), 1e-13*stiffness);
        }
    }, objectiveMaterials());
}


TEST(solidElement, forcesTurnWithTheFrame)
{
    Random random(3);
    forMaterialsAndElements([&](elementPatch& patch)
    {
        patch.stage.D = patch.toNodes(randomUnknowns(patch, random, 0.05));
        const vectorField f(patch.toNodes(patch.force()));
        const tensor Q = rotation(patch, 0.8);
        patch.stage.D = (Q & (patch.X() + patch.stage.D)) - patch.X();
        const Eigen::VectorXd turned = patch.toUnknowns(vectorField(Q & f));
        EXPECT_LT((patch.force() - turned).norm(), 1e-11*turned.norm());
    }, objectiveMaterials());
}


TEST(solidElement, doesNotDependOnItsCompany)
{
    Random random(4);
    forMaterialsAndElements([&](elementPatch& patch)
    {
        patch.stage.D = patch.toNodes(randomUnknowns(patch, random, 0.05));
        const Eigen::VectorXd f = patch.force();
        const label last = (nElements - 1)*patch.nUnknowns()/nElements;
        Eigen::VectorXd x = patch.toUnknowns(patch.stage.D);
        x.head(last) *= 3;
        patch.stage.D = patch.toNodes(x);
        const label n = patch.nUnknowns() - last;
        EXPECT_EQ((patch.force().tail(n) - f.tail(n)).norm(), 0);
    });
}


TEST(solidElement, saysThatItIsInverted)
{
    forMaterialsAndElements([&](elementPatch& patch)
    {
        patch.stage.D = Zero;
        patch.force();
        EXPECT_GT(patch.minDetJ(), 0);
        patch.stage.D = cmptMultiply(vector(-2, 0, 0), patch.X());
        patch.force();
        EXPECT_LE(patch.minDetJ(), 0);
    });
}


// ************************************************************************* //
