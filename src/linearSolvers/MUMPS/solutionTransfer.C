/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "solutionTransfer.H"
#include "MUMPSInstance.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{

//- Sum of the entries before each entry
static void startOf(const UList<int>& n, List<int>& start)
{
    start.setSize(n.size());
    int sum = 0;
    forAll(n, i)
    {
        start[i] = sum;
        sum += n[i];
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solutionTransfer::plan
(
    const globalIndex& unknowns,
    const UList<int>& source
)
{
    const label nProcs = Pstream::nProcs();

    labelList owner(source.size(), label(0));
    nSend_.setSize(nProcs);
    nReceive_.setSize(nProcs);
    nSend_ = 0;
    forAll(source, i)
    {
        owner[i] = nProcs > 1 ? unknowns.whichProcID(source[i] - 1) : 0;
        ++nSend_[owner[i]];
    }

    MPI_Alltoall
    (
        nSend_.data(), 1, MPI_INT,
        nReceive_.data(), 1, MPI_INT,
        MUMPSInstance::communicator()
    );
    startOf(nSend_, sendStart_);
    startOf(nReceive_, receiveStart_);

    from_.setSize(source.size());
    List<int> next(sendStart_), number(source.size());
    forAll(source, i)
    {
        const int k = next[owner[i]]++;
        from_[k] = i;
        number[k] = source[i] - 1;
    }

    const label nReceived = receiveStart_.last() + nReceive_.last();
    List<int> received(nReceived);
    MPI_Alltoallv
    (
        number.data(), nSend_.data(), sendStart_.data(), MPI_INT,
        received.data(), nReceive_.data(), receiveStart_.data(), MPI_INT,
        MUMPSInstance::communicator()
    );

    const label start = unknowns.localStart();
    to_.setSize(nReceived);
    forAll(received, i)
    {
        to_[i] = received[i] - start;
    }

    sendBuffer_.setSize(source.size());
    receiveBuffer_.setSize(nReceived);
}


void Foam::solutionTransfer::apply
(
    const UList<scalar>& source,
    UList<scalar>& owned
)
{
    forAll(from_, i)
    {
        sendBuffer_[i] = source[from_[i]];
    }

    MPI_Alltoallv
    (
        sendBuffer_.data(), nSend_.data(), sendStart_.data(), MPI_DOUBLE,
        receiveBuffer_.data(), nReceive_.data(), receiveStart_.data(),
        MPI_DOUBLE,
        MUMPSInstance::communicator()
    );

    forAll(to_, i)
    {
        owned[to_[i]] = receiveBuffer_[i];
    }
}


// ************************************************************************* //
