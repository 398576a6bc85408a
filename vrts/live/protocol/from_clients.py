"""Everything that a client may say."""

from vrts.live.protocol.from_anybody import (
    AskProgram,
    AskReach,
    Command,
    GoOnFrom,
    HandBack,
    Join,
    Note,
    Noticed,
    Panic,
    Point,
    RaiseHand,
    RequestControl,
    Say,
    SetRate,
    Wake,
)
from vrts.live.protocol.from_supervisors import (
    Allow,
    Broadcast,
    CloseRoom,
    EndAnnouncement,
    ExportLog,
    Freeze,
    GoOn,
    HandOver,
    Kick,
    Lock,
    LowerHand,
    MakeRooms,
    Mute,
    Project,
    SetChat,
    SetScene,
    SetTurn,
    Unmute,
    WatchWall,
)

FromClient = (
    Join
    | SetRate
    | Command
    | Panic
    | RequestControl
    | HandBack
    | RaiseHand
    | Wake
    | Point
    | Say
    | Noticed
    | Note
    | AskReach
    | AskProgram
    | GoOnFrom
    | HandOver
    | LowerHand
    | Lock
    | Freeze
    | Kick
    | Allow
    | Mute
    | Unmute
    | SetChat
    | SetTurn
    | SetScene
    | GoOn
    | MakeRooms
    | CloseRoom
    | Broadcast
    | EndAnnouncement
    | WatchWall
    | Project
    | ExportLog
)
