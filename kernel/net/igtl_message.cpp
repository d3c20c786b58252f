// SPDX-License-Identifier: GPL-3.0-or-later
#include "net/igtl_message.hpp"

#include <igtlStatusMessage.h>
#include <igtlTrackingDataMessage.h>
#include <igtlTransformMessage.h>
#include <igtl_util.h>

#include <algorithm>
#include <cmath>

namespace rhexis::igtlink {
namespace {

constexpr std::size_t type_bytes = 12;
constexpr std::size_t transform_bytes = 48;
constexpr std::size_t tool_bytes = 70;
constexpr std::size_t start_bytes = 36;
constexpr std::size_t reply_bytes = 1;
constexpr std::size_t least_status_bytes = 30;
constexpr std::size_t longest_coordinates = 32;
constexpr std::size_t extended_header_bytes = 12;
constexpr std::uint64_t us_per_s = 1000000;

Error broken(const std::string& what, const std::string& allowed) { return Error{what, "OpenIGTLink", allowed}; }

struct Header {
    unsigned version = 0;
    std::string type{};
    std::string device{};
    std::int64_t time_us = 0;
    std::uint64_t body_size = 0;
    std::uint64_t crc = 0;
};

std::uint64_t u64(WireReader& reader) {
    const std::uint64_t high = reader.u32();
    return high << 32 | reader.u32();
}

unsigned u16(WireSpan bytes) { return static_cast<unsigned>(bytes[0]) << 8 | bytes[1]; }

/// The text of a field that 0s fill up.
std::string text_of(WireSpan field) { return {field.begin(), std::find(field.begin(), field.end(), std::uint8_t{0})}; }

bool is_printable(std::string_view text) {
    return std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

Header header_at(WireSpan bytes) {
    Header header;
    header.version = u16(bytes);
    header.type = text_of(bytes.subspan(2, type_bytes));
    header.device = text_of(bytes.subspan(2 + type_bytes, longest_name));
    WireReader reader(bytes.subspan(2 + type_bytes + longest_name));
    header.time_us = static_cast<std::int64_t>(us_per_s * reader.u32());
    header.time_us += static_cast<std::int64_t>(us_per_s * reader.u32() >> 32);
    header.body_size = u64(reader);
    header.crc = u64(reader);
    return header;
}

Status check_header(const Header& header) {
    if (header.version != 1 && header.version != 2) {
        return broken("a header of version " + std::to_string(header.version), "1 or 2");
    }
    if (!is_printable(header.type) || !is_printable(header.device)) {
        return broken("a name of a type or a device that cannot be read", "printable ASCII");
    }
    if (header.body_size > most_body_bytes) {
        return broken("a body of " + std::to_string(header.body_size) + " bytes, of type " + header.type,
                      "at most " + std::to_string(most_body_bytes));
    }
    return success();
}

Status check_crc(const Header& header, WireSpan body) {
    WireBytes copy(body.begin(), body.end());  // the library's function takes no const
    if (!copy.empty() && ::crc64(copy.data(), copy.size(), 0) != header.crc) {
        return broken("a body with another CRC than its header says, of type " + header.type, "");
    }
    return success();
}

/// What is left without the extended header, which says how long it and the metadata are that follow the content.
Result<WireSpan> content_of(const Header& header, WireSpan body) {
    if (header.version == 1 || body.empty()) {
        return body;
    }
    if (body.size() < extended_header_bytes) {
        return broken("an extended header of " + std::to_string(body.size()) + " bytes",
                      std::to_string(extended_header_bytes) + " or more");
    }
    const std::size_t before = u16(body);
    const std::size_t after = u16(body.subspan(2)) + std::size_t{WireReader(body.subspan(4)).u32()};
    if (before < extended_header_bytes || before > body.size() || after > body.size() - before) {
        return broken("an extended header of " + std::to_string(before) + " bytes and metadata of " +
                          std::to_string(after) + " in a body of " + std::to_string(body.size()),
                      "");
    }
    return body.subspan(before, body.size() - before - after);
}

/// The content, unpacked by the library's class for it. Its size has been checked: the library believes it.
template <typename Class>
typename Class::Pointer unpacked(const Header& header, WireSpan content) {
    WireBytes plain{0, 1};  // the version that the library knows
    plain.resize(2 + type_bytes + longest_name + 8, 0);
    std::copy(header.type.begin(), header.type.end(), plain.begin() + 2);
    append_u32(0, plain);
    append_u32(static_cast<std::uint32_t>(content.size()), plain);
    plain.resize(header_bytes, 0);
    igtl::MessageHeader::Pointer head = igtl::MessageHeader::New();
    head->InitPack();
    std::copy(plain.begin(), plain.end(), static_cast<std::uint8_t*>(head->GetPackPointer()));
    head->Unpack();
    typename Class::Pointer message = Class::New();
    message->SetMessageHeader(head);
    message->AllocatePack();
    std::copy(content.begin(), content.end(), static_cast<std::uint8_t*>(message->GetPackBodyPointer()));
    message->Unpack();
    return message;
}

Result<Pose> pose_of(const igtl::Matrix4x4& matrix, const std::string& of) {
    Mat3 turned;
    Pose pose;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            turned(row, column) = matrix[row][column];
        }
        pose.position[row] = matrix[row][3];
    }
    if (!turned.allFinite() || !pose.position.allFinite()) {
        return broken("a number that is not finite in the pose of '" + of + "'", "");
    }
    const double off = (turned.transpose() * turned - Mat3::Identity()).cwiseAbs().maxCoeff();
    if (off > off_orthonormal || turned.determinant() < 0.0) {
        return broken("the rotation of '" + of + "' is none", "orthonormal columns to 0.001, right-handed");
    }
    pose.orientation = Quat(turned).normalized();
    return pose;
}

Status wrong_size(const Header& header, WireSpan content, const std::string& allowed) {
    return broken(header.type + " of " + std::to_string(content.size()) + " bytes", allowed);
}

Status read_transform(const Header& header, WireSpan content, Message& into) {
    if (content.size() != transform_bytes) {
        return wrong_size(header, content, std::to_string(transform_bytes));
    }
    igtl::Matrix4x4 matrix{};
    unpacked<igtl::TransformMessage>(header, content)->GetMatrix(matrix);
    Result<Pose> pose = pose_of(matrix, header.device);
    if (!pose) {
        return pose.error();
    }
    into.content = Transform{std::move(pose).value()};
    return success();
}

Status read_tracking_data(const Header& header, WireSpan content, Message& into) {
    if (content.size() % tool_bytes != 0) {
        return wrong_size(header, content, std::to_string(tool_bytes) + " for each tool");
    }
    TrackingData data;
    const auto message = unpacked<igtl::TrackingDataMessage>(header, content);
    for (std::size_t i = 0; i < content.size() / tool_bytes; ++i) {
        igtl::TrackingDataElement::Pointer element;
        message->GetTrackingDataElement(static_cast<int>(i), element);
        igtl::Matrix4x4 matrix{};
        element->GetMatrix(matrix);
        const std::string name = text_of(content.subspan(i * tool_bytes, longest_name));
        if (!is_printable(name)) {
            return broken("a name of a tool that cannot be read", "printable ASCII");
        }
        Result<Pose> pose = pose_of(matrix, name);
        if (!pose) {
            return pose.error();
        }
        data.tools.push_back({name, std::move(pose).value()});
    }
    into.content = std::move(data);
    return success();
}

Status read_start(const Header& header, WireSpan content, Message& into) {
    if (content.size() != start_bytes) {
        return wrong_size(header, content, std::to_string(start_bytes));
    }
    const int period_ms = unpacked<igtl::StartTrackingDataMessage>(header, content)->GetResolution();
    if (period_ms < 0) {
        return broken("a period of " + std::to_string(period_ms) + " ms", "0 or more");
    }
    into.content = StartTracking{period_ms, text_of(content.subspan(4, longest_coordinates))};
    return success();
}

Status read_reply(const Header& header, WireSpan content, Message& into) {
    if (content.size() != reply_bytes) {
        return wrong_size(header, content, std::to_string(reply_bytes));
    }
    const auto reply = unpacked<igtl::RTSTrackingDataMessage>(header, content);
    into.content = StartReply{reply->GetStatus() == igtl::RTSTrackingDataMessage::STATUS_SUCCESS};
    return success();
}

Status read_status(const Header& header, WireSpan content, Message& into) {
    if (content.size() < least_status_bytes) {
        return wrong_size(header, content, std::to_string(least_status_bytes) + " or more");
    }
    WireBytes ended(content.begin(), content.end());
    ended.push_back(0);  // the library overwrites the last byte by one
    const auto status = unpacked<igtl::StatusMessage>(header, ended);
    into.content = DeviceStatus{status->GetCode(), status->GetSubCode(), text_of(content.subspan(10, longest_name)),
                                std::string(status->GetStatusString())};
    return success();
}

Result<Message> message_of(const Header& header, WireSpan content) {
    Message message{header.device, header.time_us, Other{header.type}};
    Status read = success();
    if (header.type == "TRANSFORM") {
        read = read_transform(header, content, message);
    } else if (header.type == "TDATA") {
        read = read_tracking_data(header, content, message);
    } else if (header.type == "STT_TDATA") {
        read = read_start(header, content, message);
    } else if (header.type == "STP_TDATA") {
        message.content = StopTracking{};
    } else if (header.type == "RTS_TDATA") {
        read = read_reply(header, content, message);
    } else if (header.type == "STATUS") {
        read = read_status(header, content, message);
    } else if (header.type == "GET_STATUS") {
        message.content = StatusRequest{};
    }
    return read ? Result<Message>(std::move(message)) : Result<Message>(read.error());
}

void set_matrix(const Pose& pose, igtl::Matrix4x4& matrix) {
    const Mat3 turned = pose.orientation.toRotationMatrix();
    igtl::IdentityMatrix(matrix);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            matrix[row][column] = static_cast<float>(turned(row, column));
        }
        matrix[row][3] = static_cast<float>(pose.position[row]);
    }
}

/// The library's message of a content.
struct Packed {
    igtl::MessageBase::Pointer operator()(const Transform& transform) const {
        const auto message = igtl::TransformMessage::New();
        igtl::Matrix4x4 matrix{};
        set_matrix(transform.pose, matrix);
        message->SetMatrix(matrix);
        return message.GetPointer();
    }
    igtl::MessageBase::Pointer operator()(const TrackingData& data) const {
        const auto message = igtl::TrackingDataMessage::New();
        for (const Tool& tool : data.tools) {
            RHEXIS_ASSERT(tool.name.size() <= longest_name);
            auto element = igtl::TrackingDataElement::New();
            igtl::Matrix4x4 matrix{};
            set_matrix(tool.pose, matrix);
            element->SetName(tool.name.c_str());
            element->SetType(igtl::TrackingDataElement::TYPE_6D);
            element->SetMatrix(matrix);
            message->AddTrackingDataElement(element);
        }
        return message.GetPointer();
    }
    igtl::MessageBase::Pointer operator()(const StartTracking& start) const {
        RHEXIS_ASSERT(start.coordinates.size() <= longest_coordinates);
        const auto message = igtl::StartTrackingDataMessage::New();
        message->SetResolution(start.period_ms);
        message->SetCoordinateName(start.coordinates.c_str());
        return message.GetPointer();
    }
    igtl::MessageBase::Pointer operator()(const StopTracking& /*stop*/) const {
        return igtl::StopTrackingDataMessage::New().GetPointer();
    }
    igtl::MessageBase::Pointer operator()(const StartReply& reply) const {
        using Reply = igtl::RTSTrackingDataMessage;
        const auto message = Reply::New();
        message->SetStatus(reply.accepted ? Reply::STATUS_SUCCESS : Reply::STATUS_ERROR);
        return message.GetPointer();
    }
    igtl::MessageBase::Pointer operator()(const DeviceStatus& status) const {
        RHEXIS_ASSERT(status.error.size() < longest_name && status.text.size() <= longest_text);
        const auto message = igtl::StatusMessage::New();
        message->SetCode(status.code);
        message->SetSubCode(status.subcode);
        message->SetErrorName(status.error.c_str());
        message->SetStatusString(status.text.c_str());
        return message.GetPointer();
    }
    igtl::MessageBase::Pointer operator()(const StatusRequest& /*request*/) const {
        return igtl::GetStatusMessage::New().GetPointer();
    }
    igtl::MessageBase::Pointer operator()(const Other& /*other*/) const {
        RHEXIS_ASSERT(false);
        return nullptr;
    }
};

}  // namespace

WireBytes bytes_of(const Message& message) {
    RHEXIS_ASSERT(message.device.size() <= longest_name && message.time_us >= 0);
    const igtl::MessageBase::Pointer packed = std::visit(Packed(), message.content);
    const std::uint64_t time_us = static_cast<std::uint64_t>(message.time_us);
    // rounded up, so that it is read as it was
    const std::uint64_t fraction = ((time_us % us_per_s << 32) + us_per_s - 1) / us_per_s;
    packed->SetDeviceName(message.device.c_str());
    packed->SetTimeStamp(static_cast<unsigned>(time_us / us_per_s), static_cast<unsigned>(fraction));
    packed->Pack();
    const auto* bytes = static_cast<const std::uint8_t*>(packed->GetPackPointer());
    WireBytes out(bytes, bytes + packed->GetPackSize());
    RHEXIS_ASSERT(out.size() <= header_bytes + most_body_bytes);
    return out;
}

Result<std::optional<Message>> Stream::next() {
    const WireSpan bytes = WireSpan(waiting_).subspan(taken_);
    const auto not_yet = [this] {
        waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(taken_));
        taken_ = 0;
        return std::optional<Message>();
    };
    if (bytes.size() < header_bytes) {
        return not_yet();
    }
    const Header header = header_at(bytes);
    if (const Status checked = check_header(header); !checked) {
        return checked.error();
    }
    const auto body_size = static_cast<std::size_t>(header.body_size);
    if (bytes.size() - header_bytes < body_size) {
        return not_yet();
    }
    const WireSpan body = bytes.subspan(header_bytes, body_size);
    if (const Status checked = check_crc(header, body); !checked) {
        return checked.error();
    }
    const Result<WireSpan> content = content_of(header, body);
    if (!content) {
        return content.error();
    }
    Result<Message> message = message_of(header, content.value());
    if (!message) {
        return message.error();
    }
    taken_ += header_bytes + body_size;
    return std::optional(std::move(message).value());
}

}  // namespace rhexis::igtlink
