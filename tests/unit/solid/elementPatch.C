/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "elementPatch.H"
#include "IFstream.H"
#include "OSspecific.H"
#include "shellLoop.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static elementBlock makeBlock
(
    const elementShape shape,
    const label order,
    const label nMeshNodes,
    const labelList& nodes
)
{
    elementBlock block;
    block.shape = shape;
    block.order = order;
    withElement(block, [&](auto E) { block.nNodes = E.nNodes; });
    block.nodes = nodes;
    block.cells = identity(nodes.size()/block.nNodes);
    block.colour(nMeshNodes);
    return block;
}

static label dimension(const elementShape shape)
{
    return shape == elementShape::TRI || shape == elementShape::QUAD ? 2 : 3;
}

//- A box of at least some nodes
static FixedList<label, 3> divisions(const label dim, const label nNodes)
{
    label n = 1;
    while (::pow(n + 1.0, scalar(dim)) < nNodes) ++n;
    return {n, n, dim == 2 ? 1 : n};
}

static List<fieldLayout::field> fields()
{
    return {{"pointD", fieldLayout::kind::VECTOR, fieldLayout::support::NODES, dimLength}};
}

static PtrList<elementScatter> makeScatter(const elementBlock& block, const fieldUnknowns& unknowns)
{
    PtrList<elementScatter> scatter;
    scatter.append(new elementScatter(block, unknowns));
    return scatter;
}

} // End namespace Foam


Foam::dictionary Foam::exampleDict(const word& type)
{
    IFstream is(getEnv("MONOLITHICFOAM_DIR") + "/etc/caseDicts/materials/" + type);
    const dictionary file(is);
    dictionary dict(file.subDict(file.first()->keyword()));
    if (dict.found("bulkModulus")) dict.set("bulkModulus", 2e6);
    return dict;
}


Foam::autoPtr<Foam::solidMaterial> Foam::exampleMaterial(const word& type)
{
    return solidMaterial::New(exampleDict(type));
}


Foam::wordList Foam::allMaterials()
{
    return solidMaterial::dictionaryConstructorTablePtr_->sortedToc();
}


Foam::wordList Foam::objectiveMaterials()
{
    wordList all;
    for (const word& type : allMaterials()) if (type != "linearElastic") all.append(type);
    return all;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::elementPatch::elementPatch
(
    const solidMaterial& material,
    const elementShape shape,
    const label order,
    const vectorField& X,
    const labelList& nodes
)
:
    material_(material),
    loop_(material.elementLoop()),
    dim_(dimension(shape)),
    X_(X),
    block_(makeBlock(shape, order, X.size(), nodes)),
    box_
    (
        "hex", divisions(dim_, X.size()), [](const point& p) { return p; },
        dim_ == 2 ? shapeMesh::twoD() : HashTable<word>()
    ),
    fe_(box_.mesh(), 1, dictionary()),
    layout_(fe_, fields()),
    map_(layout_.keys(), fieldUnknowns::counts(layout_)),
    unknowns_(layout_, map_),
    scatter_(makeScatter(block_, unknowns_)),
    K_(map_, map_, nullptr, scatter_),
    minDetJ_(GREAT),
    stage(X_, {0, 1, 2})
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::elementPatch::beShell()
{
    loop_.reset(new shellLoop(material_));
}


Eigen::VectorXd Foam::elementPatch::toUnknowns(const vectorField& f) const
{
    Eigen::VectorXd x(nUnknowns());
    forAll(f, n) for (label a = 0; a < dim_; ++a) x[n*dim_ + a] = f[n][a];
    return x;
}


Foam::vectorField Foam::elementPatch::toNodes(const Eigen::VectorXd& x) const
{
    vectorField f(X_.size(), Zero);
    forAll(f, n) for (label a = 0; a < dim_; ++a) f[n][a] = x[n*dim_ + a];
    return f;
}


Eigen::VectorXd Foam::elementPatch::force()
{
    vectorField f(X_.size(), Zero);
    minDetJ_ = loop_->assemble(block_, stage, f, nullptr);
    return toUnknowns(f);
}


Eigen::MatrixXd Foam::elementPatch::tangent()
{
    K_.clear();
    vectorField f(X_.size(), Zero);
    const solidMatrix to{K_, scatter_[0]};
    minDetJ_ = loop_->assemble(block_, stage, f, &to);

    labelList row, col;
    scalarField value;
    K_.triplets(row, col);
    K_.values(value);
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(nUnknowns(), nUnknowns());
    // The box may have more nodes than the patch: these have no elements
    forAll(value, k) if (row[k] < K.rows()) K(row[k], col[k]) += value[k];
    return K;
}


Foam::label Foam::elementPatch::solve
(
    const Eigen::VectorXd& f,
    const labelList& fixed
)
{
    Eigen::VectorXd x = toUnknowns(stage.D);
    for (label iter = 1; iter <= 30; ++iter)
    {
        Eigen::VectorXd r = f - force();
        Eigen::MatrixXd K = tangent();
        for (const label u : fixed)
        {
            K.row(u).setZero();
            K.col(u).setZero();
            K(u, u) = 1;
            r[u] = 0;
        }
        const Eigen::VectorXd dx = K.ldlt().solve(r);
        x += dx;
        stage.D = toNodes(x);
        if (dx.norm() < 1e-8*x.norm()) return iter;
    }
    return -1;
}


// ************************************************************************* //
