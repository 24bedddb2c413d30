// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SimulatedRanks.h"

#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkDummyController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

#include <condition_variable>
#include <cstring>
#include <deque>
#include <exception>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace geodesic::testing
{
namespace
{

/** The messages that were sent to one rank and that it has not received yet. */
class Mailbox
{
public:
  using Message = std::vector<char>;

  void put(int sender, int tag, Message message)
  {
    {
      const std::lock_guard lock(this->Mutex);
      this->Messages[{ sender, tag }].push_back(std::move(message));
    }
    this->HasNew.notify_one();
  }

  /** Waits for the next message of a sender with a tag. */
  Message take(int sender, int tag)
  {
    std::unique_lock lock(this->Mutex);
    std::deque<Message>& waiting = this->Messages[{ sender, tag }];
    this->HasNew.wait(lock, [&] { return !waiting.empty(); });
    Message message = std::move(waiting.front());
    waiting.pop_front();
    return message;
  }

private:
  std::mutex Mutex;
  std::condition_variable HasNew;
  std::map<std::pair<int, int>, std::deque<Message>> Messages;
};

/** Sends by putting messages into the mailboxes of other ranks of this process. */
class MailCommunicator : public vtkCommunicator
{
public:
  static MailCommunicator* New();
  vtkTypeMacro(MailCommunicator, vtkCommunicator);

  void join(int rank, std::vector<Mailbox>& mailboxes)
  {
    this->LocalProcessId = rank;
    this->SetNumberOfProcesses(static_cast<int>(mailboxes.size()));
    this->Mailboxes = &mailboxes;
  }

  int SendVoidArray(const void* data, vtkIdType length, int type, int receiver, int tag) override
  {
    const char* first = static_cast<const char*>(data);
    const vtkIdType bytes = length * vtkDataArray::GetDataTypeSize(type);
    (*this->Mailboxes)[receiver].put(this->LocalProcessId, tag, { first, first + bytes });
    return 1;
  }

  int ReceiveVoidArray(void* data, vtkIdType length, int type, int sender, int tag) override
  {
    const Mailbox::Message message = (*this->Mailboxes)[this->LocalProcessId].take(sender, tag);
    const vtkIdType size = vtkDataArray::GetDataTypeSize(type);
    this->Count = static_cast<vtkIdType>(message.size()) / size;
    if (this->Count > length)
    {
      return 0;
    }
    std::memcpy(data, message.data(), message.size());
    return 1;
  }

private:
  std::vector<Mailbox>* Mailboxes = nullptr;
};
vtkStandardNewMacro(MailCommunicator);

}

void runOnRanks(int ranks, const std::function<void(vtkMultiProcessController*)>& work)
{
  std::vector<Mailbox> mailboxes(ranks);
  std::vector<vtkNew<vtkDummyController>> controllers(ranks);
  std::vector<std::exception_ptr> errors(ranks);
  std::vector<std::thread> threads;
  for (int rank = 0; rank < ranks; ++rank)
  {
    vtkNew<MailCommunicator> communicator;
    communicator->join(rank, mailboxes);
    controllers[rank]->SetCommunicator(communicator);
    threads.emplace_back(
      [&work, &error = errors[rank], controller = controllers[rank].Get()]
      {
        try
        {
          work(controller);
        }
        catch (...)
        {
          error = std::current_exception();
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (const std::exception_ptr& error : errors)
  {
    if (error)
    {
      std::rethrow_exception(error);
    }
  }
}

}
