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
#include "materialTest.H"
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
void checkRotation(const solidMaterial& law, const bool isotropic)
{
    typedef Ten<scalar, d> ten;
    Random random(3);
    const ten Q = rotation<d>(0.7), F = ten::I() + randomTensor<d>(random, 0.15);
    const scalar modulus = norm(law.dP(ten::I(), ten::I()));

    EXPECT_LT(norm(law.P(Q)), 1e-14*modulus);
    EXPECT_LT(mag(law.W(Q)), 1e-14*modulus);
    EXPECT_NEAR(law.W(Q & F), law.W(F), 1e-13*modulus);
    if (isotropic)
    {
        EXPECT_NEAR(law.W(F & Q), law.W(F), 1e-13*modulus);
    }
    EXPECT_LT(norm(law.P(Q & F) - (Q & law.P(F))), 1e-13*modulus);
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
    EXPECT_GE(allMaterials().size(), 9);
    for (const word& type : allMaterials()) EXPECT_EQ(exampleDict(type).get<word>("type"), type);
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
    for (const word& type : objectiveMaterials())
    {
        SCOPED_TRACE(type);
        const bool isotropic = type != "fibreReinforced";
        checkRotation<2>(exampleMaterial(type)(), isotropic);
        checkRotation<3>(exampleMaterial(type)(), isotropic);
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

    for (const char* type : {"StVenantKirchhoff", "neoHookean", "linearElastic"})
    {
        for (const char* moduli : {"E 100; nu 0.3;", "mu 38.461538461538462; lambda 57.692307692307692;"})
        {
            IStringStream is(std::string("type ") + type + "; rho 1; " + moduli);
            const autoPtr<solidMaterial> law = solidMaterial::New(dictionary(is));
            EXPECT_LT(norm(law->P(Ten<scalar, 3>::I() + H) - hooke), 1e-5*norm(hooke)) << type;
        }
    }
}


//- Of mixed laws too: the moduli are those that the material tells
TEST(material, smallStrainHasTheModuliOfMixedLaws)
{
    Random random(6);
    for (const word& type : allMaterials())
    {
        const autoPtr<solidMaterial> any = exampleMaterial(type);
        const auto* law = dynamic_cast<const mixedMaterial*>(any.get());
        if (!law) continue;
        const Ten<scalar, 3> H = randomTensor<3>(random, 1e-7);
        const scalar kappa = 1/law->rKappa(), mu = law->shearModulus();
        const Ten<scalar, 3> hooke = (mu*(H + H.t())).addDiag((kappa - 2*mu/3)*tr(H));
        EXPECT_LT(norm(law->dP(Ten<scalar, 3>::I(), H) - hooke), 1e-12*norm(hooke)) << type;
    }
}


//- Piso is the derivative of Wiso, and volume makes no part of them
TEST(material, mixedLawsPartDistortionAndVolume)
{
    Random random(7);
    label n = 0;
    for (const word& type : allMaterials())
    {
        const autoPtr<solidMaterial> any = exampleMaterial(type);
        const auto* law = dynamic_cast<const mixedMaterial*>(any.get());
        if (!law) continue;
        SCOPED_TRACE(type);
        ++n;
        const Ten<scalar, 3> F = Ten<scalar, 3>::I() + randomTensor<3>(random, 0.2);
        const Ten<scalar, 3> dF = randomTensor<3>(random, 1), P = law->Piso(F);
        const scalar h = 1e-5;
        EXPECT_NEAR(law->Wiso(1.3*F), law->Wiso(F), 1e-12*law->Wiso(F));
        EXPECT_NEAR(tr(P & F.t()), 0, 1e-13*norm(P)*norm(F));
        EXPECT_NEAR((law->Wiso(F + h*dF) - law->Wiso(F - h*dF))/(2*h), P && dF, 1e-6*norm(P)*norm(dF));
        const Ten<scalar, 3> dP = (1/(2*h))*(law->Piso(F + h*dF) - law->Piso(F - h*dF));
        EXPECT_LT(norm(dP - law->dPiso(F, dF)), 1e-6*norm(dP));
    }
    EXPECT_GE(n, 6);
}


//- Nominal stress of uniaxial and equibiaxial tension and of pure shear without
//  change of volume, the lateral faces free, against closed forms: benchmarks
//  of Mooney's law and the formulas of the others
TEST(material, hasTheStressesOfHomogeneousTension)
{
    const auto stress = [](const string& entries, const scalar l1, const scalar l2)
    {
        IStringStream is(entries + "rho 1;");
        const autoPtr<solidMaterial> any = solidMaterial::New(dictionary(is));
        Ten<scalar, 3> F = Ten<scalar, 3>::I();
        F(0, 0) = l1; F(1, 1) = l2; F(2, 2) = 1/(l1*l2);
        const Ten<scalar, 3> P = dynamic_cast<const mixedMaterial&>(any()).Piso(F);
        return P(0, 0) - P(2, 2)*F(2, 2)/l1;
    };
    const auto uniaxial = [&](const string& e, const scalar l) { return stress(e, l, 1/::sqrt(l)); };
    const string mooney("type MooneyRivlin; c1 3; c2 0.7;");
    for (const scalar l : {0.5, 0.75, 1.25, 2.0, 3.0})
    {
        const scalar l2 = l*l, a = l - 1/l2, I1 = l2 + 2/l, I2 = 2*l + 1/l2;
        const auto expectNear = [&](const scalar s, const scalar exact)
        {
            EXPECT_NEAR(s, exact, 1e-12*mag(exact)) << l;
        };
        expectNear(uniaxial(mooney, l), 2*a*(3 + 0.7/l));
        expectNear(stress(mooney, l, l), 2*(l - ::pow(l, -5))*(3 + 0.7*l2));
        expectNear(stress(mooney, l, 1), 2*(l - ::pow(l, -3))*3.7);

        const scalar x = I1 - 3, y = I2 - 3;
        const scalar W1 = 3 + 2*0.2*x + 0.1*y + 3*0.04*x*x + 2*0.03*x*y + 0.02*y*y;
        const scalar W2 = 0.7 + 0.1*x + 2*0.3*y + 0.03*x*x + 2*0.02*x*y + 3*0.01*y*y;
        expectNear
        (
            uniaxial
            (
                "type MooneyRivlin; c1 3; c2 0.7; c3 0.2; c4 0.1; c5 0.3; c6 0.04; c7 0.03;"
                " c8 0.02; c9 0.01;", l
            ), 2*a*(W1 + W2/l)
        );
        expectNear(uniaxial("type isochoricNeoHookean; mu 6;", l), 6*a);
        expectNear(uniaxial("type Yeoh; c10 3; c20 -0.1; c30 0.02;", l), 2*a*(3 - 0.2*x + 0.06*x*x));
        expectNear
        (
            uniaxial("type Ogden; mu (6 -0.1); alpha (1.3 -2);", l),
            6*(::pow(l, 0.3) - ::pow(l, -1.65)) - 0.1*(::pow(l, -3) - 1)
        );

        const scalar L2 = 9, C[5] = {0.5, 1.0/20, 11.0/1050, 19.0/7000, 519.0/673750};
        scalar W = 0, mu = 0;
        for (label k = 1; k <= 5; ++k)
        {
            W += k*C[k - 1]*::pow(I1/L2, k - 1.0);
            mu += 2*k*C[k - 1]*::pow(3/L2, k - 1.0);
        }
        expectNear(uniaxial("type ArrudaBoyce; mu 2; lockingStretch 3;", l), 2*a*W*2/mu);
    }

    // Along the fibres, which do not resist compression
    const string tendon("type fibreReinforced; mu 1; k1 2; k2 0.5; direction (1 0 0);");
    const scalar e = 1.21 - 1;
    EXPECT_NEAR(uniaxial(tendon, 1.1), 1.1 - 1/1.21 + 2*1.1*2*e*::exp(0.5*e*e), 1e-12);
    EXPECT_NEAR(uniaxial(tendon, 0.9), 0.9 - 1/0.81, 1e-12);
}


//- Principal stretches that are equal, or nearly, are no matter
TEST(material, OgdenDoesNotDependOnTheOrderOfStretches)
{
    const autoPtr<solidMaterial> law = exampleMaterial("Ogden");
    Random random(8);
    typedef Ten<scalar, 3> ten;
    const ten dF = randomTensor<3>(random, 1);
    const auto at = [&](const scalar gap)
    {
        ten F = 1.2*ten::I();
        F(1, 1) += gap;
        return law->dP(F, dF);
    };
    for (const scalar gap : {1e-14, 1e-10, 1e-7, 1e-5})
    {
        EXPECT_LT(norm(at(gap) - at(0)), 10*(gap + 1e-14)*norm(at(0))) << gap;
    }
}


TEST(material, fibresLieInThePlaneOfTheCase)
{
    const auto stress = [](const char* direction, const FixedList<label, 3>& axes)
    {
        IStringStream is(string("type fibreReinforced; rho 1; mu 1; k1 2; k2 1; direction ") + direction + ";");
        autoPtr<solidMaterial> law = solidMaterial::New(dictionary(is));
        law->setAxes(axes);
        Ten<scalar, 2> F = Ten<scalar, 2>::I();
        F(1, 1) = 1.1;
        return dynamic_cast<const mixedMaterial&>(law()).Piso(F)(1, 1);
    };
    const scalar along = stress("(0 1 0)", {0, 1, 2});
    EXPECT_GT(along, 1.5*stress("(0 0 1)", {0, 1, 2}));
    EXPECT_NEAR(along, stress("(0 0 3)", {0, 2, 1}), 1e-14);
}


//- The laboratory's loads: closed forms of Mooney's law, and Hooke's for others
TEST(material, hasTheLoadsOfTests)
{
    typedef materialTest::mode mode;
    const auto law = [](const char* entries)
    {
        IStringStream is(entries);
        return solidMaterial::New(dictionary(is));
    };
    const auto mooney = law("type MooneyRivlin; rho 1; c1 3; c2 0.7;");
    const materialTest test(mooney());
    const scalar l = 1.7;
    EXPECT_NEAR(test.load(mode::UNIAXIAL, l), 2*(l - 1/(l*l))*(3 + 0.7/l), 1e-11);
    EXPECT_NEAR(test.load(mode::EQUIBIAXIAL, l), 2*(l - ::pow(l, -5))*(3 + 0.7*l*l), 1e-11);
    EXPECT_NEAR(test.load(mode::PLANAR, l), 2*(l - ::pow(l, -3))*3.7, 1e-11);
    EXPECT_NEAR(test.load(mode::SHEAR, 0.4), 2*3.7*0.4, 1e-12);
    EXPECT_THROW(test.load(mode::VOLUMETRIC, 0.9), Foam::error);

    const scalar e = 1e-6, E = 100, nu = 0.3;
    for (const char* entries : {"type StVenantKirchhoff; rho 1; E 100; nu 0.3;", "type neoHookean; rho 1; E 100; nu 0.3;"})
    {
        const auto metal = law(entries);
        const materialTest small(metal());
        EXPECT_NEAR(small.load(mode::UNIAXIAL, 1 + e), E*e, 1e-5*E*e);
        EXPECT_NEAR(small.load(mode::EQUIBIAXIAL, 1 + e), E/(1 - nu)*e, 1e-5*E*e);
        EXPECT_NEAR(small.load(mode::PLANAR, 1 + e), E/(1 - nu*nu)*e, 1e-5*E*e);
        EXPECT_NEAR(small.load(mode::SHEAR, e), E/(2*(1 + nu))*e, 1e-5*E*e);
        EXPECT_NEAR(small.load(mode::VOLUMETRIC, 1 - e), E/(3*(1 - 2*nu))*e, 1e-5*E*e);
    }
}


TEST(material, mixedLawsComplainAboutTheirDictionary)
{
    expectComplaint("type MooneyRivlin; rho 1; c1 1; c2 -1;", "shear modulus of small strains is 0");
    expectComplaint("type MooneyRivlin; rho 1;", "shear modulus of small strains is 0");
    expectComplaint("type MooneyRivlin; rho 1; c1 1; bulkModulus -1;", "bulkModulus is -1");
    expectComplaint("type MooneyRivlin; rho 1; c1 [0 1 0 0 0 0 0] 1;", "imension");
    expectComplaint("type isochoricNeoHookean; rho 1; mu 0;", "mu is 0");
    expectComplaint("type Yeoh; rho 1; c10 -1;", "c10 is -1");
    expectComplaint("type ArrudaBoyce; rho 1; mu 1; lockingStretch 1;", "lockingStretch is 1");
    expectComplaint("type Ogden; rho 1; mu (1 2); alpha (1);", "two lists");
    expectComplaint("type Ogden; rho 1; mu (1); alpha (0);", "two lists");
    expectComplaint("type Ogden; rho 1; mu (1); alpha (-2);", "shear modulus of small strains is -1");
    expectComplaint
    (
        "type fibreReinforced; rho 1; mu 1; k1 1; k2 1; direction (0 0 0);", "a vector that is not nil"
    );
    expectComplaint("type fibreReinforced; rho 1; mu 1; k1 1; k2 0; direction (1 0 0);", "k2 is 0");
    EXPECT_EQ(complaintAbout("type MooneyRivlin; rho 1; c2 [1 -1 -2 0 0 0 0] 1;"), "");
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
