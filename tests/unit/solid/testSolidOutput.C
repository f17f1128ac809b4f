/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Tests of what a solid puts out: stresses and strains at cells and points,
    integrals.
\*---------------------------------------------------------------------------*/

#include "solidCase.H"
#include "Random.H"

using namespace Foam;

namespace
{

void cube(solidCase& c, const std::string& elements, const std::string& material)
{
    c.blockMesh =
        "vertices ((0 0 0) (1 0.1 0) (1 1 0) (0 1 0.1) (0 0 1) (1 0 1) (1.2 1 1) (0 1 1));"
        "blocks (hex (0 1 2 3 4 5 6 7) one (2 2 2) simpleGrading (1 1 1)); boundary ();"
        "defaultPatch { name free; type patch; }";
    c.materials = "body { rho 3; " + material + " }";
    c.elements = elements;
    c.pointD = "free { type calculated; value uniform (0 0 0); }";
    c.make();
}

const char* const neoHookean = "type neoHookean; E 100; nu 0.3;";

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

//- F = R U with principal stretches 1.3, 1.1, 0.8 along the axes
TEST(solidOutput, hasStressesAndStrainsOfAHomogeneousState)
{
    const tensor R(0, -1, 0, 1, 0, 0, 0, 0, 1), U(1.3, 0, 0, 0, 0.8, 0, 0, 0, 1.1), F(R & U);
    for (const char* elements : {"linear", "enhancedStrain", "quadratic"})
    {
        SCOPED_TRACE(elements);
        solidCase c;
        cube(c, elements, neoHookean);
        nonlinearSolid& solid = c.solid();
        solid.motion().D = ((F - tensor::I) & solid.fe().points());

        const scalar J = det(F), mu = 100/2.6, lambda = 100*0.3/(1.3*0.4);
        const tensor sigma((mu*((F & F.T()) - tensor::I) + 0.5*lambda*(J*J - 1)*tensor::I)/J);
        const scalar W = 0.5*mu*(tr(F.T() & F) - 3 - 2*::log(J)) + 0.25*lambda*(J*J - 1 - 2*::log(J));
        const auto check = [&](const auto expected, auto of)
        {
            typedef typename std::decay<decltype(expected)>::type Type;
            const Field<Type> cells(solid.cellValues<Type>(of)), points(solid.pointValues<Type>(of));
            EXPECT_EQ(cells.size(), 8);
            EXPECT_LT(max(mag(cells - expected)), 1e-11*mag(expected));
            EXPECT_LT(max(mag(points - expected)), 1e-11*mag(expected));
        };
        check(J, &solidPoint::J);
        check(W, &solidPoint::energyDensity);
        check(symm(sigma), &solidPoint::sigma);
        check(tensor(J*sigma & inv(F).T()), &solidPoint::firstPiola);
        check(symm(J*(inv(F) & sigma & inv(F).T())), &solidPoint::secondPiola);
        check(symm(0.5*((F.T() & F) - tensor::I)), &solidPoint::GreenStrain);
        check(symmTensor(::log(0.8), 0, 0, ::log(1.3), 0, ::log(1.1)), &solidPoint::logStrain);
        check(vector(1.3, 1.1, 0.8), &solidPoint::principalStretch);
        check(vector(sigma.yy(), sigma.zz(), sigma.xx()), &solidPoint::principalStress);
        const tensor rows = solid.cellValues<tensor>(&solidPoint::principalDirections)()[0];
        EXPECT_LT(mag(cmptMag(rows) - tensor(0, 1, 0, 0, 0, 1, 1, 0, 0)), 1e-12);
    }
}


//- A stress that is linear in space has its values at the points, by elements of
//  order 2
TEST(solidOutput, extrapolatesToThePoints)
{
    solidCase c;
    c.blockMesh =
        "vertices ((0 0 0) (1 0 0) (1 1 0) (0 1 0) (0 0 1) (1 0 1) (1 1 1) (0 1 1));"
        "blocks (hex (0 1 2 3 4 5 6 7) one (2 1 3) simpleGrading (1 1 2)); boundary ();"
        "defaultPatch { name free; type patch; }";
    c.materials = "body { rho 1; type linearElastic; E 100; nu 0; }";
    c.elements = "quadratic";
    c.pointD = "free { type calculated; value uniform (0 0 0); }";
    c.make();
    const vectorField& X = c.solid->fe().points();
    forAll(X, n) c.solid->motion().D[n] = 1e-9*vector(0.5*sqr(X[n].x()), 0, 2*X[n].y()*X[n].z());
    const symmTensorField sigma(c.solid->pointValues<symmTensor>(&solidPoint::sigma));
    forAll(sigma, p)
    {
        const point& x = c.solid->mesh().points()[p];
        EXPECT_LT(mag(sigma[p] - 1e-7*symmTensor(x.x(), 0, 0, 0, x.z(), 2*x.y())), 1e-13);
    }
}


//- The force is the gradient of the strain energy, in enhanced elements, too
TEST(solidOutput, strainEnergyHasTheForcesForItsGradient)
{
    const std::string rubber("type MooneyRivlin; c1 10; c2 3; bulkModulus 80;");
    struct { const char* elements; std::string material, prestress; } cases[] =
    {
        {"linear", neoHookean, ""}, {"enhancedStrain", neoHookean, ""}, {"enhancedStrain", rubber, ""},
        {"quadratic", rubber, ""}, {"quadratic", rubber, "uniform (30 5 -3 -20 4 10)"}
    };
    for (const auto& run : cases)
    {
        SCOPED_TRACE(run.elements);
        solidCase c;
        c.prestress = run.prestress;
        cube(c, run.elements, run.material);
        Foam::Random random(1);
        scalarField x(c.nUnknowns()), dx(x);
        for (scalar& s : x) s = 0.04*random.GaussNormal<scalar>();
        for (scalar& s : dx) s = random.GaussNormal<scalar>();
        c.next();
        c.update(x);
        const scalar power = sumProd(c.residual(), dx), h = 1e-5;
        c.update(h*dx);
        const scalar W = c.solid->integrals().strain;
        c.update(-2*h*dx);
        EXPECT_NEAR((W - c.solid->integrals().strain)/(2*h), power, 1e-6*mag(power));
    }
}


//- At rest the stress is that of the reference configuration; its tangent
TEST(solidOutput, hasAPrestress)
{
    for (const char* elements : {"linear", "quadratic", "Q1Q0"})
    {
        SCOPED_TRACE(elements);
        solidCase c;
        c.prestress = "uniform (30 5 -3 -20 4 10)";
        cube(c, elements, "type MooneyRivlin; c1 10; c2 3; bulkModulus 80;");
        EXPECT_LT(max(mag(c.solid->cellValues<symmTensor>(&solidPoint::sigma) - symmTensor(30, 5, -3, -20, 4, 10))), 1e-12);

        Foam::Random random(1);
        scalarField x(c.nUnknowns()), dx(x);
        for (scalar& s : x) s = 0.04*random.GaussNormal<scalar>();
        for (scalar& s : dx) s = random.GaussNormal<scalar>();
        c.next();
        c.update(x);
        EXPECT_LT(c.tangentError(dx), 1e-6);
    }
}


//- A unit cube that spins and moves on
TEST(solidOutput, integratesTheMotion)
{
    solidCase c;
    c.blockMesh =
        "vertices ((0 0 0) (1 0 0) (1 1 0) (0 1 0) (0 0 1) (1 0 1) (1 1 1) (0 1 1));"
        "blocks (hex (0 1 2 3 4 5 6 7) one (2 2 2) simpleGrading (1 1 1)); boundary ();"
        "defaultPatch { name free; type patch; }";
    c.materials = "body { rho 3; type MooneyRivlin; c1 10; }";
    c.elements = "Q1Q0";
    c.pointD = "free { type calculated; value uniform (0 0 0); }";
    c.make();
    const vectorField& X = c.solid->fe().points();
    const vector middle(0.5, 0.5, 0.5), omega(0, 0, 2), v(1, 0, 0), d(0, 4, 0);
    forAll(X, n)
    {
        c.solid->motion().D[n] = d;
        c.solid->motion().v[n] = v + (omega ^ (X[n] - middle));
    }
    const solidIntegrals s(c.solid->integrals());
    EXPECT_NEAR(s.mass, 3, 1e-13);
    EXPECT_NEAR(s.kinetic, 0.5*3*(1 + 4/6.0), 1e-13);
    EXPECT_LT(mag(s.momentum - 3*v), 1e-13);
    EXPECT_LT(mag(s.angularMomentum - (3*omega/6 + ((middle + d) ^ (3*v)))), 1e-13);
    EXPECT_NEAR(s.strain, 0, 1e-13);
}


// ************************************************************************* //
