/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Tests of all materials of the selection table, and of what their
    dictionaries may hold.
\*---------------------------------------------------------------------------*/

#include "elementPatch.H"
#include "IStringStream.H"
#include <gtest/gtest.h>

using namespace Foam;

namespace
{

template<int d>
Ten<scalar, d> randomTensor(Random& random, const scalar size)
{
    Ten<scalar, d> A;
    for (int i = 0; i < d; ++i) for (int j = 0; j < d; ++j) A(i, j) = size*random.GaussNormal<scalar>();
    return A;
}

template<int d>
Ten<scalar, d> rotation(const scalar angle)
{
    Ten<scalar, d> Q = Ten<scalar, d>::I();
    Q(0, 0) = Q(1, 1) = ::cos(angle);
    Q(0, 1) = -(Q(1, 0) = ::sin(angle));
    if constexpr (d == 3)
    {
        Ten<scalar, 3> Q2 = Ten<scalar, 3>::I();
        Q2(1, 1) = Q2(2, 2) = ::cos(2*angle);
        Q2(1, 2) = -(Q2(2, 1) = ::sin(2*angle));
        Q = Q & Q2;
    }
    return Q;
}

template<int d>
scalar norm(const Ten<scalar, d>& A) { return ::sqrt(A && A); }


template<int d>
void checkDerivatives(const solidMaterial& law)
{
    Random random(2);
    for (int n = 0; n < 10; ++n)
    {
        const Ten<scalar, d> F = Ten<scalar, d>::I() + randomTensor<d>(random, 0.15);
        const Ten<scalar, d> dF = randomTensor<d>(random, 1);
        const scalar h = 1e-5;
        const Ten<scalar, d> Fp = F + h*dF, Fm = F - h*dF;

        const Ten<scalar, d> P = law.P(F), dP = law.dP(F, dF);
        EXPECT_NEAR((law.W(Fp) - law.W(Fm))/(2*h), P && dF, 1e-6*norm(P)*norm(dF));
        EXPECT_LT(norm((1/(2*h))*(law.P(Fp) - law.P(Fm)) - dP), 1e-6*norm(dP));
    }
}


template<int d>
void checkRotation(const solidMaterial& law)
{
    typedef Ten<scalar, d> ten;
    Random random(3);
    const ten Q = rotation<d>(0.7), F = ten::I() + randomTensor<d>(random, 0.15);
    const scalar modulus = norm(law.dP(ten::I(), ten::I()));

    EXPECT_LT(norm(law.P(Q)), 1e-14*modulus);
    EXPECT_LT(mag(law.W(Q)), 1e-14*modulus);
    EXPECT_NEAR(law.W(Q & F), law.W(F), 1e-13*modulus);
    EXPECT_NEAR(law.W(F & Q), law.W(F), 1e-13*modulus);
    EXPECT_LT(norm(law.P(Q & F) - (Q & law.P(F))), 1e-13*modulus);
}


wordList allMaterials()
{
    return solidMaterial::dictionaryConstructorTablePtr_->sortedToc();
}


//- The message of the FatalIOError that a dictionary gives
std::string complaintAbout(const string& entries)
{
    const bool throwing = FatalIOError.throwExceptions();
    std::string message;
    try
    {
        IStringStream is(entries);
        solidMaterial::New(dictionary(is));
    }
    catch (const Foam::IOerror& error)
    {
        message = error.message();
    }
    FatalIOError.throwExceptions(throwing);
    return message;
}

void expectComplaint(const string& entries, const std::string& part)
{
    const std::string message = complaintAbout(entries);
    EXPECT_NE(message.find(part), std::string::npos) << entries << " gives: " << message;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(material, hasAnExample)
{
    EXPECT_GE(allMaterials().size(), 2);
    for (const word& type : allMaterials()) EXPECT_TRUE(exampleMaterials().found(type)) << type;
}


TEST(material, stressAndItsDerivativeAreThoseOfTheEnergy)
{
    for (const word& type : allMaterials())
    {
        SCOPED_TRACE(type);
        checkDerivatives<2>(exampleMaterial(type)());
        checkDerivatives<3>(exampleMaterial(type)());
    }
}


TEST(material, doesNotSeeRotations)
{
    for (const word& type : allMaterials())
    {
        SCOPED_TRACE(type);
        checkRotation<2>(exampleMaterial(type)());
        checkRotation<3>(exampleMaterial(type)());
    }
}


TEST(material, isPlaneStrainInTwoDimensions)
{
    Random random(4);
    const Ten<scalar, 2> F2 = Ten<scalar, 2>::I() + randomTensor<2>(random, 0.2);
    Ten<scalar, 3> F3 = Ten<scalar, 3>::I();
    for (int i = 0; i < 2; ++i) for (int j = 0; j < 2; ++j) F3(i, j) = F2(i, j);

    for (const word& type : allMaterials())
    {
        SCOPED_TRACE(type);
        const autoPtr<solidMaterial> law = exampleMaterial(type);
        EXPECT_NEAR(law->W(F2), law->W(F3), 1e-13*law->W(F3));
        const Ten<scalar, 2> P2 = law->P(F2);
        const Ten<scalar, 3> P3 = law->P(F3);
        for (int i = 0; i < 2; ++i) for (int j = 0; j < 2; ++j)
        {
            EXPECT_NEAR(P2(i, j), P3(i, j), 1e-13*norm(P3));
        }
    }
}


TEST(material, smallStrainIsHookesLaw)
{
    const scalar E = 100, nu = 0.3, mu = E/(2*(1 + nu)), lambda = E*nu/((1 + nu)*(1 - 2*nu));
    Random random(5);
    const Ten<scalar, 3> H = randomTensor<3>(random, 1e-7);
    const Ten<scalar, 3> hooke = (mu*(H + H.t())).addDiag(lambda*tr(H));

    for (const char* type : {"StVenantKirchhoff", "neoHookean"})
    {
        for (const char* moduli : {"E 100; nu 0.3;", "mu 38.461538461538462; lambda 57.692307692307692;"})
        {
            IStringStream is(std::string("type ") + type + "; rho 1; " + moduli);
            const autoPtr<solidMaterial> law = solidMaterial::New(dictionary(is));
            EXPECT_LT(norm(law->P(Ten<scalar, 3>::I() + H) - hooke), 1e-5*norm(hooke)) << type;
        }
    }
}


TEST(material, complainsAboutItsDictionary)
{
    expectComplaint("type rubber; rho 1; E 1; nu 0;", "StVenantKirchhoff");
    expectComplaint("rho 1; E 1; nu 0;", "type");
    expectComplaint("type neoHookean; E 1; nu 0;", "rho");
    expectComplaint("type neoHookean; rho -1; E 1; nu 0;", "rho is -1");
    expectComplaint("type neoHookean; rho 1; nu 0.3;", "E");
    expectComplaint("type neoHookean; rho 1; E 1;", "nu");
    expectComplaint("type neoHookean; rho 1; E -1; nu 0.3;", "E is -1");
    expectComplaint("type neoHookean; rho 1; E 1; nu 0.5;", "nu is 0.5");
    expectComplaint("type neoHookean; rho 1; E 1; nu -1;", "nu is -1");
    expectComplaint("type neoHookean; rho 1; mu 1; lambda -1;", "lambda is -1");
    expectComplaint("type neoHookean; rho 1; E 1; lambda 1;", "both pairs");
    expectComplaint("type neoHookean; rho 1;", "no moduli");
    expectComplaint("type neoHookean; rho 1; E [1 -1 -1 0 0 0 0] 1; nu 0.3;", "imension");
    EXPECT_EQ(complaintAbout("type neoHookean; rho [1 -3 0 0 0 0 0] 1; E 1; nu 0.3;"), "");
}


// ************************************************************************* //
