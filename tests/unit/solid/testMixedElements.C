/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Tests of the mixed elements with all laws that they have.
\*---------------------------------------------------------------------------*/

#include "elementPatch.H"
#include "mixedMaterial.H"
#include "mixedElementLoop.H"
#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- Disconnected mixed elements E of a material, each distorted in its own way. A
//  box that has as many nodes lends the numbers of its own
class mixedPatch
{
    autoPtr<mixedElementLoop> loop_;
    vectorField X_;
    elementBlock block_;
    autoPtr<shapeMesh> box_;
    autoPtr<feMesh> fe_;
    autoPtr<fieldLayout> layout_;
    autoPtr<nodeMap> map_;
    autoPtr<fieldUnknowns> unknowns_;
    PtrList<elementScatter> scatter_;
    autoPtr<feMatrix> K_;

public:

    scalar minDetJ = GREAT;
    autoPtr<mixedStage> stage;

    template<class E>
    mixedPatch
    (
        const E&,
        const mixedMaterial& law,
        const elementShape shape,
        const fieldLayout::support on,
        const label nElements
    )
    :
        loop_(law.mixedLoop())
    {
        Foam::Random random(1);
        X_ = vectorField(nElements*E::nNodes, Zero);
        forAll(X_, n)
        {
            vector& x = X_[n];
            for (int a = 0; a < E::dim; ++a)
            {
                x[a] = E::xi[n % E::nNodes][a] + 0.03*random.GaussNormal<scalar>();
            }
            x = vector(x.x() + 0.3*x.y(), x.y() - 0.2*x.x() + 0.1*x.z(), 0.7*x.z());
        }
        block_.shape = shape;
        block_.order = E::order;
        block_.nNodes = E::nNodes;
        block_.nodes = identity(X_.size());
        block_.cells = identity(nElements);
        block_.colour(X_.size());

        label n = 1;
        while (::pow(n + 1.0, scalar(E::dim)) < X_.size()) ++n;
        box_.reset
        (
            new shapeMesh
            (
                "hex", {n, n, E::dim == 2 ? 1 : n}, [](const point& p) { return p; },
                E::dim == 2 ? shapeMesh::twoD() : HashTable<word>()
            )
        );
        typedef fieldLayout layout;
        fe_.reset(new feMesh(box_->mesh(), 1, dictionary()));
        const List<layout::field> fields
        ({
            {"pointD", layout::kind::VECTOR, layout::support::NODES, dimLength},
            {"solidPressure", layout::kind::SCALAR, on, dimPressure}
        });
        layout_.reset(new fieldLayout(fe_(), fields));
        map_.reset(new nodeMap(layout_->keys(), fieldUnknowns::counts(layout_())));
        unknowns_.reset(new fieldUnknowns(layout_(), map_()));
        scatter_.append(new elementScatter(block_, unknowns_()));
        K_.reset(new feMatrix(map_(), map_(), nullptr, scatter_));

        stage.reset(new mixedStage(X_, {0, 1, 2}));
        stage->pressureOn = on;
        stage->p.setSize(layout_->size(1), 0);
    }

    label nUnknowns() const { return map_->nUnknowns(); }
    const vectorField& X() const { return X_; }

    boolList isPressure() const
    {
        boolList is(nUnknowns(), false);
        forAll(stage->p, i) is[unknowns_->start(1, i)] = true;
        return is;
    }

    //- Residual by unknown
    Eigen::VectorXd residual()
    {
        vectorField force(layout_->size(0), Zero);
        scalarField volume(layout_->size(1), 0), R(nUnknowns(), 0);
        minDetJ = loop_->assemble(block_, stage(), force, volume, nullptr);
        unknowns_->add(0, force, R);
        unknowns_->add(1, volume, R);
        return Eigen::Map<Eigen::VectorXd>(R.data(), R.size());
    }

    Eigen::MatrixXd tangent()
    {
        K_->clear();
        vectorField force(layout_->size(0), Zero);
        scalarField volume(layout_->size(1), 0), value;
        const solidMatrix to{K_(), scatter_[0]};
        loop_->assemble(block_, stage(), force, volume, &to);
        labelList row, col;
        K_->triplets(row, col);
        K_->values(value);
        Eigen::MatrixXd K = Eigen::MatrixXd::Zero(nUnknowns(), nUnknowns());
        forAll(value, k) K(row[k], col[k]) += value[k];
        return K;
    }

    //- Values at the stage for unknowns u, p
    void set(const Eigen::VectorXd& x)
    {
        const scalarField u(UList<scalar>(const_cast<scalar*>(x.data()), x.size()));
        forAll(X_, n)
        {
            stage->D[n] = stage->dDdu*unknowns_->at(0, n, u);
            stage->a[n] = stage->dadu*unknowns_->at(0, n, u);
        }
        forAll(stage->p, i) stage->p[i] = u[unknowns_->start(1, i)];
    }

    Eigen::VectorXd random(Foam::Random& random, const scalar sizeD, const scalar sizeP)
    {
        Eigen::VectorXd x(nUnknowns());
        for (label u = 0; u < x.size(); ++u) x[u] = sizeD*random.GaussNormal<scalar>();
        forAll(stage->p, i) x[unknowns_->start(1, i)] = sizeP*random.GaussNormal<scalar>();
        return x;
    }
};


const label nElements = packSize + 3;

//- Call f(patch, law) for all laws and elements; with rKappa nil, too
template<class F>
void forMixed(const F& f)
{
    typedef fieldLayout::support on;
    for (const word& type : allMaterials()) for (const bool incompressible : {false, true})
    {
        dictionary dict(exampleDict(type));
        if (incompressible) dict.remove("bulkModulus");
        const autoPtr<solidMaterial> any = solidMaterial::New(dict);
        const auto* law = dynamic_cast<const mixedMaterial*>(any.get());
        if (!law) continue;

        const auto test = [&](const auto E, const elementShape shape, const on place)
        {
            typedef typename std::decay<decltype(E)>::type element;
            mixedPatch patch(E, *law, shape, place, nElements);
            SCOPED_TRACE(type + " " + element::name + (place == on::CELLS ? " P0" : ""));
            f(patch, *law);
        };
        test(Quad1(), elementShape::QUAD, on::CELLS);
        test(Hex1(), elementShape::HEX, on::CELLS);
        test(Tri1(), elementShape::TRI, on::VERTICES);
        test(Quad1(), elementShape::QUAD, on::VERTICES);
        test(Tet1(), elementShape::TET, on::VERTICES);
        test(Hex1(), elementShape::HEX, on::VERTICES);
        test(Prism1(), elementShape::PRISM, on::VERTICES);
        test(Pyramid1(), elementShape::PYRAMID, on::VERTICES);
        test(Tri2(), elementShape::TRI, on::VERTICES);
        test(Quad2(), elementShape::QUAD, on::VERTICES);
        test(Tet2(), elementShape::TET, on::VERTICES);
        test(Hex2(), elementShape::HEX, on::VERTICES);
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(mixedElement, tangentIsTheDerivativeOfTheResidual)
{
    Foam::Random random(1);
    forMixed([&](mixedPatch& patch, const mixedMaterial& law)
    {
        patch.stage->g = vector(1, -2, 0.5);
        patch.stage->dDdu = 0.3;
        patch.stage->dadu = 7;
        const scalar mu = law.shearModulus(), h = 1e-5;
        const Eigen::VectorXd x = patch.random(random, 0.07, mu), dx = patch.random(random, 1, mu);

        patch.set(x + h*dx);
        const Eigen::VectorXd Rp = patch.residual();
        patch.set(x - h*dx);
        const Eigen::VectorXd Rm = patch.residual();
        patch.set(x);
        Eigen::MatrixXd K = patch.tangent();
        ASSERT_GT(patch.minDetJ, 0);

        // Forces and volumes, each beside its own
        const Eigen::VectorXd KdX = K*dx, difference = (Rp - Rm)/(2*h) - KdX;
        const boolList isP(patch.isPressure());
        scalar force = 0, volume = 0, dForce = 0, dVolume = 0;
        for (label u = 0; u < KdX.size(); ++u)
        {
            (isP[u] ? volume : force) += sqr(KdX[u]);
            (isP[u] ? dVolume : dForce) += sqr(difference[u]);
        }
        EXPECT_LT(dForce, sqr(1e-6)*force);
        EXPECT_LT(dVolume, sqr(1e-6)*volume);
    });
}


//- Beside the factor that the time scheme gives the displacement
TEST(mixedElement, tangentIsSymmetric)
{
    Foam::Random random(2);
    forMixed([&](mixedPatch& patch, const mixedMaterial& law)
    {
        patch.set(patch.random(random, 0.03, law.shearModulus()));
        const Eigen::MatrixXd K = patch.tangent();
        EXPECT_LT((K - K.transpose()).norm(), 1e-13*K.norm());
    });
}


//- A rotation makes neither forces nor volume, and pressure on it only its own
TEST(mixedElement, rigidMotionMakesNoForce)
{
    const scalar c = ::cos(1.1), s = ::sin(1.1);
    const tensor Q(c, -s, 0, s, c, 0, 0, 0, 1);
    forMixed([&](mixedPatch& patch, const mixedMaterial& law)
    {
        patch.stage->D = (Q & patch.X()) - patch.X() + vector(1, 2, 0);
        EXPECT_LT(patch.residual().norm(), 1e-12*patch.tangent().norm());
    });
}


//- With a bulk modulus p = -kappa (J - 1) solves the volume's equation exactly
TEST(mixedElement, uniformPressureIsThatOfTheVolume)
{
    const tensor H(0.1, 0.05, 0, -0.05, 0.08, 0, 0, 0, 0);
    forMixed([&](mixedPatch& patch, const mixedMaterial& law)
    {
        if (law.rKappa() == 0) return;
        patch.stage->D = (H & patch.X());
        patch.stage->p = -(det(tensor::I + H) - 1)/law.rKappa();
        const Eigen::VectorXd R = patch.residual();
        const boolList isP(patch.isPressure());
        for (label u = 0; u < R.size(); ++u) EXPECT_LT(isP[u]*mag(R[u]), 1e-14);
    });
}


TEST(mixedElement, saysThatItIsInverted)
{
    forMixed([&](mixedPatch& patch, const mixedMaterial&)
    {
        patch.residual();
        EXPECT_GT(patch.minDetJ, 0);
        patch.stage->D = cmptMultiply(vector(-2, 0, 0), patch.X());
        patch.residual();
        EXPECT_LE(patch.minDetJ, 0);
    });
}


// ************************************************************************* //
