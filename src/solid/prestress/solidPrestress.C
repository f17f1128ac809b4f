/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidPrestress.H"
#include "solidKernel.H"
#include "volFields.H"
#include <memory>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class E>
void Foam::solidPrestress::assembleOf
(
    const elementBlock& block,
    const solidStage& stage,
    vectorField& force,
    const solidMatrix* matrix
) const
{
    constexpr int dim = E::dim, nN = E::nNodes;

    #pragma omp parallel
    {
        const auto n = std::make_unique<solidNodes<pack, E>>();
        const auto K = std::make_unique<solidTangent<pack, E>>();
        feValues<pack, E> w;

        block.forBatches([&](const label batch)
        {
            gather<E, dim>(block, batch, stage.X, stage.axis, n->X);
            gather<E, dim>(block, batch, stage.D, stage.axis, n->D);
            Ten<pack, dim> S0;
            for (int l = 0; l < packSize; ++l) for (int a = 0; a < dim; ++a) for (int b = 0; b < dim; ++b)
            {
                const tensor S(S0_[block.cells[block.lane(batch, l)]]);
                S0(a, b)[l] = S(stage.axis[a], stage.axis[b]);
            }

            Vec<pack, dim> R[nN];
            for (Vec<pack, dim>& r : R) r = Vec<pack, dim>::zero();
            for (auto& row : K->uu) for (Ten<pack, dim>& A : row) A = Ten<pack, dim>::zero();
            for (int q = 0; q < w.nQ; ++q)
            {
                w.reinit(n->X, q);
                const Ten<pack, dim> F = w.grad(n->D).addDiag(pack(1.0));
                for (int j = 0; j < nN; ++j)
                {
                    const Vec<pack, dim> s = (S0 & w.dN[j])*w.dV;
                    R[j] += F & s;
                    if (matrix) for (int i = 0; i < nN; ++i) K->uu[i][j].addDiag(stage.dDdu*(w.dN[i] & s));
                }
            }

            for (int l = 0; l < block.nLanes(batch); ++l)
            {
                const label* nodes = block.element(block.lane(batch, l));
                for (int i = 0; i < nN; ++i) for (int a = 0; a < dim; ++a)
                {
                    force[nodes[i]][stage.axis[a]] += R[i][a][l];
                }
            }
            if (matrix) matrix->K.add(matrix->scatter, block, batch, &K->uu[0][0](0, 0), 0, 0, 1);
        });
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::solidPrestress> Foam::solidPrestress::New(const fvMesh& mesh)
{
    const word instance
    (
        mesh.time().findInstance(mesh.dbDir(), "prestress", IOobject::READ_IF_PRESENT)
    );
    IOobject io("prestress", instance, mesh, IOobject::MUST_READ, IOobject::NO_WRITE, false);
    if (!returnReduce(io.typeHeaderOk<volSymmTensorField>(), orOp<bool>())) return nullptr;

    const volSymmTensorField S0(io, mesh);
    if (S0.dimensions() != dimPressure)
    {
        FatalErrorInFunction
            << "Field " << S0.objectPath() << " has the dimensions " << S0.dimensions()
            << ", expected those of a stress, " << dimPressure << exit(FatalError);
    }
    Info<< "Region " << mesh.name() << ": prestress of time " << instance << ", largest component "
        << gMax(cmptMag(S0.primitiveField())().component(0)) << endl;
    return autoPtr<solidPrestress>::New(S0.primitiveField());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solidPrestress::assemble
(
    const elementBlock& block,
    const solidStage& stage,
    vectorField& force,
    const solidMatrix* matrix
) const
{
    withElement(block, [&](auto tag) { assembleOf<decltype(tag)>(block, stage, force, matrix); });
}


// ************************************************************************* //
